#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


def cb(m):
    t = Twist()
    t.linear.x = 0.2 if m.data < 2 else 0.0
    pub.publish(t)


rospy.init_node('turtle_mover')
pub = rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=1)
rospy.Subscriber('moved_distance', Float64, cb)
rospy.spin()
