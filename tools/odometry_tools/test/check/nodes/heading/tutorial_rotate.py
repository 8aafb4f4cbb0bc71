#!/usr/bin/env python3
"""The tutorial's P-controller as it is printed there, in Python 3 and with names of our own."""
import math

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

roll = pitch = yaw = 0.0
target = 90
gain = 0.5


def get_rotation(message):
    global roll, pitch, yaw
    q = message.pose.pose.orientation
    (roll, pitch, yaw) = euler_from_quaternion([q.x, q.y, q.z, q.w])


rospy.init_node('rotate_robot')
subscriber = rospy.Subscriber('/odom', Odometry, get_rotation)
publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
command = Twist()
while not rospy.is_shutdown():
    target_rad = target * math.pi / 180
    command.angular.z = gain * (target_rad - yaw)
    publisher.publish(command)
    print('target={} current:{}'.format(target, yaw))
    rate.sleep()
