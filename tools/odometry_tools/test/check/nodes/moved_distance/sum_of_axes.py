#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

last, total = None, 0.0


def cb(m):
    global last, total
    p = m.pose.pose.position
    if last:
        total += abs(p.x - last.x) + abs(p.y - last.y)
    last = p
    pub.publish(total)


rospy.init_node('d')
pub = rospy.Publisher('moved_distance', Float64, queue_size=1)
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
