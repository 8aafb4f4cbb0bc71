#!/usr/bin/env python3
"""Reads the heading from tf."""
import math
import rospy
import tf
from geometry_msgs.msg import Twist

rospy.init_node('tf_rotate')
listener = tf.TransformListener()
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    try:
        _, rotation = listener.lookupTransform('odom', 'base_footprint', rospy.Time(0))
    except (tf.LookupException, tf.ConnectivityException, tf.ExtrapolationException):
        rate.sleep()
        continue
    error = math.pi / 2 - tf.transformations.euler_from_quaternion(rotation)[2]
    error = math.atan2(math.sin(error), math.cos(error))
    command = Twist()
    command.angular.z = max(-0.8, min(0.8, error))
    pub.publish(command)
    rate.sleep()
