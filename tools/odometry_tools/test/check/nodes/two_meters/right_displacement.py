#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


class TwoMetres:
    def __init__(self):
        self.start = None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(self.stop)
        rospy.Subscriber('odom', Odometry, self.odom)

    def stop(self):
        self.pub.publish(Twist())

    def odom(self, msg):
        p = msg.pose.pose.position
        if self.start is None:
            self.start = p
        cmd = Twist()
        if math.hypot(p.x - self.start.x, p.y - self.start.y) < 2.0:
            cmd.linear.x = 0.15
        self.pub.publish(cmd)


rospy.init_node('two_metres')
TwoMetres()
rospy.spin()
