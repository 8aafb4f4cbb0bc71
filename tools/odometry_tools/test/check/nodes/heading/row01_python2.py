#!/usr/bin/env python
import rospy
from nav_msgs.msg import Odometry

def callback(msg):
    print msg.pose.pose.orientation

rospy.init_node('rotate')
rospy.Subscriber('/odom', Odometry, callback)
rospy.spin()
