#!/usr/bin/env python3
"""Counts the yaw on over 180 degrees, and picks the nearest of all headings that are 90."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

unwound = last = goal = None


def cb(msg):
    global unwound, last, goal
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]
    if last is None:
        unwound = yaw
        goal = min((math.radians(90 + turn) for turn in (-360, 0, 360)), key=lambda g: abs(g - yaw))
    else:
        step = yaw - last
        if step > math.pi:
            step -= 2 * math.pi
        elif step < -math.pi:
            step += 2 * math.pi
        unwound += step
    last = yaw


rospy.init_node('unwound')
rospy.Subscriber('odom', Odometry, cb)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rate = rospy.Rate(25)
while not rospy.is_shutdown():
    if goal is not None:
        t = Twist()
        t.angular.z = 0.5 * (goal - unwound)
        pub.publish(t)
    rate.sleep()
