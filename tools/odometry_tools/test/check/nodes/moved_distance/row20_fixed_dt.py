#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

distance = Float64()


def callback(msg):
    distance.data += msg.twist.twist.linear.x * 0.1
    pub.publish(distance)


rospy.init_node('speed_integrator')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, callback)
rospy.spin()
