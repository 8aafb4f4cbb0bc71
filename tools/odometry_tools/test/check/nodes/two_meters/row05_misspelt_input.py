#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


def cb(m):
    t = Twist()
    t.linear.x = 0.2 if m.data < 2 else 0.0
    pub.publish(t)


rospy.init_node('mover')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.Subscriber('/moved_distence', Float64, cb)
rospy.spin()
