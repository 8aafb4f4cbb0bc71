#!/usr/bin/env python3
"""Sleeps a second by wall time before it begins, which harms nobody."""
import time
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

rospy.init_node('sleepy')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
time.sleep(1)
first = rospy.wait_for_message('odom', Odometry).pose.pose.position
gone = 0.0


def cb(msg):
    global gone
    p = msg.pose.pose.position
    gone = math.sqrt((p.x - first.x) ** 2 + (p.y - first.y) ** 2)


rospy.Subscriber('odom', Odometry, cb)
rate = rospy.Rate(30)
while not rospy.is_shutdown():
    t = Twist()
    t.linear.x = 0.3 if gone < 2 else 0
    pub.publish(t)
    rate.sleep()
