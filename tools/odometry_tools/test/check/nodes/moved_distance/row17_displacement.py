#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

start = None


def callback(msg):
    global start
    p = msg.pose.pose.position
    if start is None:
        start = p
    pub.publish(math.sqrt((p.x - start.x) ** 2 + (p.y - start.y) ** 2))


rospy.init_node('distance')
pub = rospy.Publisher('/moved_distance', Float64, queue_size=10)
rospy.Subscriber('/odom', Odometry, callback)
rospy.spin()
