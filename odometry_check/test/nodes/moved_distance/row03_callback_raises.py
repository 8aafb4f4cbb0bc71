#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class Detector:
    def __init__(self):
        self.total = 0.0
        self.pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.cb)

    def cb(self, msg):
        x, y = msg.pose.pose.position.x, msg.pose.pose.position.y
        self.total += math.hypot(x - self.last_x, y - self.last_y)
        self.last_x, self.last_y = x, y
        self.pub.publish(self.total)


rospy.init_node('detector')
Detector()
rospy.spin()
