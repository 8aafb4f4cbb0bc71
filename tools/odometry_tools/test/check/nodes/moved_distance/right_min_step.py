#!/usr/bin/env python3
"""Leaves out steps below a millimetre until they add up."""
import numpy as np
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

reference, total = None, 0.0


def callback(msg):
    global reference, total
    p = np.array([msg.pose.pose.position.x, msg.pose.pose.position.y, 0.0])
    if reference is None:
        reference = p
    step = np.linalg.norm(p - reference)
    if step > 0.005:
        total += step
        reference = p
    pub.publish(float(total))


rospy.init_node('min_step')
pub = rospy.Publisher('moved_distance', Float64, queue_size=10)
rospy.Subscriber('odom', Odometry, callback)
rospy.spin()
