#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class Detector:
    def __init__(self):
        self.pub = rospy.Publisher('/moved_distance', Float64, queue_size=1)
        self.total = 0.0
        self.old = None
        rospy.Subscriber('/odom', Odometry, self.cb)

    def cb(self, msg):
        new = msg.pose.pose.position
        if self.old is not None:
            dx = new.x - self.old.x
            dy = new.y - new.y
            self.total += math.sqrt(dx * dx + dy * dy)
        self.old = new
        self.pub.publish(Float64(self.total))


if __name__ == '__main__':
    rospy.init_node('detector')
    Detector()
    rospy.spin()
