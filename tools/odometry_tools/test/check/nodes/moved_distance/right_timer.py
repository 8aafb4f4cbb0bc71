#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class Odometer:
    """Publishes ten times a second, whatever the odometry's rate."""

    def __init__(self):
        self.total, self.last = 0.0, None
        self.pub = rospy.Publisher('/moved_distance', Float64, queue_size=1, latch=True)
        rospy.Subscriber('/odom', Odometry, self.on_odom)
        rospy.Timer(rospy.Duration(0.1), lambda event: self.pub.publish(self.total))

    def on_odom(self, msg):
        here = (msg.pose.pose.position.x, msg.pose.pose.position.y)
        if self.last:
            self.total += math.dist(here, self.last)
        self.last = here


rospy.init_node('odometer')
Odometer()
rospy.spin()
