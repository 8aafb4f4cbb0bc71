#!/usr/bin/env python3
"""The tutorial's detector as it is printed there, in Python 3 and with names of our own."""
import math

import rospy
from geometry_msgs.msg import Point
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class MovementDetector(object):
    def __init__(self):
        self.moved = Float64()
        self.moved.data = 0.0
        self.wait_for_start()
        self.publisher = rospy.Publisher('/moved_distance', Float64, queue_size=1)
        rospy.Subscriber('/odom', Odometry, self.on_odom)

    def wait_for_start(self):
        message = None
        while message is None:
            try:
                message = rospy.wait_for_message('/odom', Odometry, timeout=1)
            except:
                rospy.loginfo('no odom yet, trying again')
        self.position = Point()
        self.position.x = message.pose.pose.position.x
        self.position.y = message.pose.pose.position.y
        self.position.z = message.pose.pose.position.z

    def on_odom(self, message):
        new = message.pose.pose.position
        self.moved.data += self.distance(new, self.position)
        self.position = new
        if self.moved.data < 0.000001:
            aux = Float64()
            aux.data = 0.0
            self.publisher.publish(aux)
        else:
            self.publisher.publish(self.moved)

    def distance(self, new, old):
        x = new.x - old.x
        y = new.y - old.y
        return math.hypot(x, y)


if __name__ == '__main__':
    rospy.init_node('movement_detector_node', anonymous=True)
    detector = MovementDetector()
    rospy.spin()
