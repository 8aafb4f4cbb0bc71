#!/usr/bin/env python3
"""Stops at 1.95 m: inside the tolerance, with a note."""
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


def cb(msg):
    t = Twist()
    if round(msg.data, 1) < 2.0:
        t.linear.x = 0.1
    pub.publish(t)


rospy.init_node('rounded')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('moved_distance', Float64, cb)
rospy.spin()
