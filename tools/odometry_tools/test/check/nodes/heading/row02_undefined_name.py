#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = 0.0


def on_odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


def turn():
    rospy.init_node('turner')
    rospy.Subscriber('odom', Odometry, on_odom)
    pub = rospy.Publisher('cmd_vel', Twist, queue_size=10)
    rate = rospy.Rate(10)
    atDest = False
    while not atTarget:
        cmd = Twist()
        cmd.angular.z = 0.5 * (math.pi / 2 - yaw)
        pub.publish(cmd)
        atDest = abs(math.pi / 2 - yaw) < 0.01
        rate.sleep()


turn()
