#!/usr/bin/env python3
import rospy
import numpy as np
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

rot = [0, 0, 0]


def read(msg):
    global rot
    o = msg.pose.pose.orientation
    rot = euler_from_quaternion([o.x, o.y, o.z, o.w])


rospy.init_node('slowly')
rospy.Subscriber('/odom', Odometry, read)
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
r = rospy.Rate(10)
while not rospy.is_shutdown():
    err = np.deg2rad(90) - rot[2]
    err = np.arctan2(np.sin(err), np.cos(err))
    msg = Twist()
    msg.angular.z = 0.01 * err
    pub.publish(msg)
    r.sleep()
