#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

moved = 0.0


def callback(msg):
    global moved
    moved = msg.data


rospy.init_node('test_movement')
rospy.Subscriber('/moved_distance', Float64, callback)
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
move = Twist()
move.linear.x = 0.1
while moved < 2 and not rospy.is_shutdown():
    pub.publish(move)
    rate.sleep()
