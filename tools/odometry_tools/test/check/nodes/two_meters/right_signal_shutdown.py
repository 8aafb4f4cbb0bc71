#!/usr/bin/env python3
"""Ends itself at the goal, by an exception that nobody catches."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


class Go:
    def __init__(self):
        self.start = None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.cmd = Twist()
        rospy.on_shutdown(self.stop)
        rospy.Subscriber('odom', Odometry, self.odom)

    def stop(self):
        self.cmd = Twist()
        self.pub.publish(self.cmd)

    def odom(self, m):
        p = m.pose.pose.position
        self.start = self.start or p
        self.cmd.linear.x = 0.2
        if math.hypot(p.x - self.start.x, p.y - self.start.y) >= 2:
            self.stop()
            rospy.signal_shutdown('there')

    def run(self):
        rate = rospy.Rate(10)
        while True:
            self.pub.publish(self.cmd)
            rate.sleep()


rospy.init_node('go')
Go().run()
