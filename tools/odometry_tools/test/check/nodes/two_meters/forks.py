#!/usr/bin/env python3
"""Starts a child that drives for ever, and ends."""
import os
import rospy
from geometry_msgs.msg import Twist

if os.fork():
    os._exit(0)
os.setsid()
rospy.init_node('child')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
t = Twist()
t.linear.x = 0.3
while True:
    pub.publish(t)
    rospy.rostime.wallsleep(0.1)
