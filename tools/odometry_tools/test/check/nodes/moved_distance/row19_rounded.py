#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

total, last = 0.0, None


def callback(msg):
    global total, last
    x = round(msg.pose.pose.position.x, 2)
    y = round(msg.pose.pose.position.y, 2)
    if last:
        total += math.hypot(x - last[0], y - last[1])
    last = x, y
    pub.publish(total)


rospy.init_node('rounded')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, callback)
rospy.spin()
