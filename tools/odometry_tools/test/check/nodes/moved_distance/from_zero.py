#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

prev_x = prev_y = total = 0.0


def callback(msg):
    global prev_x, prev_y, total
    p = msg.pose.pose.position
    total += math.hypot(p.x - prev_x, p.y - prev_y)
    prev_x, prev_y = p.x, p.y
    pub.publish(total)


rospy.init_node('from_zero')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, callback)
rospy.spin()
