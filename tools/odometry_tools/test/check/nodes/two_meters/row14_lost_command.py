#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist

rospy.init_node('go')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
move = Twist()
move.linear.x = 0.2
pub.publish(move)
