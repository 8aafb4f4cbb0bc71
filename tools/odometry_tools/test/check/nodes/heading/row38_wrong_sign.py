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
rospy.Subscriber('/odom', Odometry, odom)
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(20)
while not rospy.is_shutdown():
    error = yaw - math.radians(90)
    while error > math.pi:
        error -= 2 * math.pi
    while error < -math.pi:
        error += 2 * math.pi
    t = Twist()
    t.angular.z = 0.5 * error
    pub.publish(t)
    rate.sleep()
