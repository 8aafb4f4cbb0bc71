#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist

def move()
    pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)

rospy.init_node('move')
move()
