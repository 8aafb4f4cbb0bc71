#!/usr/bin/env python3
import rospy
from math import sqrt, pow
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class Detector:
    def __init__(self):
        rospy.init_node('detector_loop', anonymous=True)
        self.first = True
        self.x = self.y = 0
        self.dist = 0
        self.sub = rospy.Subscriber('odom', Odometry, self.cb)
        self.pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
        self.rate = rospy.Rate(20)

    def cb(self, data):
        if self.first:
            self.x, self.y = data.pose.pose.position.x, data.pose.pose.position.y
            self.first = False
        x, y = data.pose.pose.position.x, data.pose.pose.position.y
        self.dist += sqrt(pow(x - self.x, 2) + pow(y - self.y, 2))
        self.x, self.y = x, y

    def loop(self):
        while not rospy.is_shutdown():
            self.pub.publish(self.dist)
            self.rate.sleep()


try:
    Detector().loop()
except rospy.ROSInterruptException:
    pass
