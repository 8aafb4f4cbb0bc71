#!/usr/bin/env python3
"""The tutorial's mover as it is printed there, in Python 3 and with names of our own."""
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


def on_moved(message):
    if message.data < 2:
        move.linear.x = 0.1
    if message.data > 2:
        move.linear.x = 0
    publisher.publish(move)


rospy.init_node('test_movement')
subscriber = rospy.Subscriber('/moved_distance', Float64, on_moved)
publisher = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
move = Twist()
rospy.spin()
