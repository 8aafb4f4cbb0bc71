#!/usr/bin/env python3
import math
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float32

last, total = None, 0.0


def cb(m):
    global last, total
    p = m.pose.pose.position
    if last:
        total += math.hypot(p.x - last.x, p.y - last.y)
    last = p
    pub.publish(total)


rospy.init_node('d')
pub = rospy.Publisher('moved_distance', Float32, queue_size=1)
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
