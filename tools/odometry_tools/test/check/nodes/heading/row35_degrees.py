#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

TARGET = 90
yaw = 0


def odom_cb(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('rotate')
rospy.Subscriber('/odom', Odometry, odom_cb)
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=10)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    move = Twist()
    move.angular.z = 0.5 * (TARGET - yaw)
    pub.publish(move)
    rate.sleep()
