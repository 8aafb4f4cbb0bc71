#!/usr/bin/env python3
"""Right at 20 Hz only."""
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

total = 0.0


def callback(msg):
    global total
    total = total + abs(msg.twist.twist.linear.x) * 0.05
    pub.publish(total)


rospy.init_node('speed')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, callback)
rospy.spin()
