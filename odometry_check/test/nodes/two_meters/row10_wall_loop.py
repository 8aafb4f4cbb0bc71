#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

moved = 0


def cb(m):
    global moved
    moved = m.data


rospy.init_node('stubborn', disable_signals=True)
import signal
signal.signal(signal.SIGINT, signal.SIG_IGN)
rospy.Subscriber('moved_distance', Float64, cb)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
while True:
    t = Twist()
    t.linear.x = 0.2 if moved < 2 else 0.0
    pub.publish(t)
    rate.sleep()
