#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


class Drive:
    def __init__(self):
        self.begin = None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.look)

    def look(self, msg):
        p = msg.pose.pose.position
        if self.begin is None:
            self.begin = p
            go = Twist()
            go.linear.x = 0.1
            self.pub.publish(go)
        if math.hypot(p.x - self.begin.x, p.y - self.begin.y) >= 2:
            self.pub.publish(Twist())


rospy.init_node('drive')
Drive()
rospy.spin()
