#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = None


def odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('turn')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(10)
while yaw is None:
    rate.sleep()


def error():
    return math.atan2(math.sin(math.pi / 2 - yaw), math.cos(math.pi / 2 - yaw))


while abs(error()) > 0.15 and not rospy.is_shutdown():
    t = Twist()
    t.angular.z = math.copysign(0.3, error())
    pub.publish(t)
    rate.sleep()
