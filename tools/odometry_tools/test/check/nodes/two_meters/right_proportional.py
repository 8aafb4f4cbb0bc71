#!/usr/bin/env python3
"""Slows down near the goal."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry


class P:
    def __init__(self):
        self.start = self.pos = None
        rospy.Subscriber('/odom', Odometry, self.cb, queue_size=1)
        self.pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(lambda: self.pub.publish(Twist()))

    def cb(self, m):
        self.pos = (m.pose.pose.position.x, m.pose.pose.position.y)
        self.start = self.start or self.pos

    def run(self):
        r = rospy.Rate(10)
        while not rospy.is_shutdown():
            if self.pos:
                left = 2.0 - math.dist(self.pos, self.start)
                t = Twist()
                if abs(left) > 0.005:
                    t.linear.x = max(-0.3, min(0.3, 0.8 * left))
                self.pub.publish(t)
            r.sleep()


rospy.init_node('p_drive')
P().run()
