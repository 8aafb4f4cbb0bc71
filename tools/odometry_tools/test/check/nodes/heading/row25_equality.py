#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = 0.0


def odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('turn')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(10)
while yaw != math.pi / 2:
    t = Twist()
    t.angular.z = 0.5
    pub.publish(t)
    rate.sleep()
pub.publish(Twist())
