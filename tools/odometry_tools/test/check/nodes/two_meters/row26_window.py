#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


class Mover:
    def __init__(self):
        self.first = None
        self.there = False
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(lambda: self.pub.publish(Twist()))
        rospy.Subscriber('odom', Odometry, self.odom)

    def odom(self, msg):
        p = msg.pose.pose.position
        self.first = self.first or p
        gone = math.sqrt((p.x - self.first.x) ** 2 + (p.y - self.first.y) ** 2)
        if abs(gone - 2.0) < 0.02:
            self.there = True
        t = Twist()
        t.linear.x = 0.0 if self.there else 0.5
        self.pub.publish(t)


rospy.init_node('mover')
Mover()
rospy.spin()
