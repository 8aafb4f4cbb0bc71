#!/usr/bin/env python3
"""Right, at a speed that the base does not have."""
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64


class Fast:
    def __init__(self):
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(lambda: self.pub.publish(Twist()))
        rospy.Subscriber('moved_distance', Float64, self.cb)

    def cb(self, msg):
        t = Twist()
        t.linear.x = 1.0 if msg.data < 2 else 0
        self.pub.publish(t)


rospy.init_node('fast')
Fast()
rospy.spin()
