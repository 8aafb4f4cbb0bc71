#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

START = []
TOLERANCE = 0.07


def cb(msg):
    p = msg.pose.pose.position
    if not START:
        START.extend([p.x, p.y])
    left = 2.0 - math.hypot(p.x - START[0], p.y - START[1])
    cmd = Twist()
    if left > TOLERANCE:
        cmd.linear.x = 0.1
    pub.publish(cmd)


rospy.init_node('drive')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
