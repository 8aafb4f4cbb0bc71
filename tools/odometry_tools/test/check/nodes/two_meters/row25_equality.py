#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

d = 0.0


def moved(msg):
    global d
    d = msg.data


rospy.init_node('mover')
rospy.Subscriber('moved_distance', Float64, moved)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rate = rospy.Rate(10)
vel = Twist()
vel.linear.x = 0.3
while d != 2.0 and not rospy.is_shutdown():
    pub.publish(vel)
    rate.sleep()
vel.linear.x = 0.0
pub.publish(vel)
