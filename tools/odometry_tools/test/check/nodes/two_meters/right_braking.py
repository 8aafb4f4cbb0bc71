#!/usr/bin/env python3
"""Fast, and stops early by the braking way."""
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

SPEED = 0.6
BRAKING = SPEED ** 2 / (2 * 2.9) + SPEED * 0.03


def cb(msg):
    cmd = Twist()
    cmd.linear.x = SPEED if msg.data < 2.0 - BRAKING else 0.0
    pub.publish(cmd)


rospy.init_node('fast_mover')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('moved_distance', Float64, cb)
rospy.spin()
