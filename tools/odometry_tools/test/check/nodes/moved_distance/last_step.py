#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

last = None


def cb(m):
    global last
    p = m.pose.pose.position
    moved = 0.0
    if last:
        moved += math.hypot(p.x - last.x, p.y - last.y)
    last = p
    pub.publish(moved)


rospy.init_node('d')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
