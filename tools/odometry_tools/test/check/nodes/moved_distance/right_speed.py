#!/usr/bin/env python3
"""Integrates the absolute speed over the true time."""
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64


def on_odom(msg):
    stamp = msg.header.stamp
    if on_odom.stamp is not None:
        on_odom.total += abs(msg.twist.twist.linear.x) * (stamp - on_odom.stamp).to_sec()
    on_odom.stamp = stamp
    pub.publish(Float64(on_odom.total))


on_odom.stamp, on_odom.total = None, 0.0
rospy.init_node('speed_sum')
pub = rospy.Publisher('/moved_distance', Float64, queue_size=1)
rospy.Subscriber('/odom', Odometry, on_odom)
rospy.spin()
