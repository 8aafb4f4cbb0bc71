#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


class Integrator:
    def __init__(self):
        self.total = 0.0
        self.before = None
        self.pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.add)

    def add(self, msg):
        now = msg.header.stamp.to_sec()
        if self.before is not None:
            self.total += msg.twist.twist.linear.x * (now - self.before)
        self.before = now
        self.pub.publish(self.total)


rospy.init_node('integrator')
Integrator()
rospy.spin()
