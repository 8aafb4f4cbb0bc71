#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class D:
    def __init__(self):
        self.p, self.sum = None, 0.0
        self.pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.cb)

    def step(self, p):
        d = math.hypot(p.x - self.p.x, p.y - self.p.y) if self.p else 0.0
        self.sum += d
        return d

    def cb(self, m):
        d = self.step(m.pose.pose.position)
        self.sum = self.sum + d
        self.p = m.pose.pose.position
        self.pub.publish(self.sum)


rospy.init_node('d')
D()
rospy.spin()
