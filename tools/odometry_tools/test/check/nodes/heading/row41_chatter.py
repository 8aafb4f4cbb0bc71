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


rospy.init_node('rotate')
rospy.Subscriber('odom', Odometry, odom)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    error = math.radians(90) - yaw
    if error > math.pi:
        error -= 2 * math.pi
    twist = Twist()
    if error > 0:
        twist.angular.z = 0.2
    else:
        twist.angular.z = -0.2
    pub.publish(twist)
    rate.sleep()
