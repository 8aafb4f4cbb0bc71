#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

start = None
distance = 0.0


def cb(msg):
    global start, distance
    p = msg.pose.pose.position
    if start is None:
        start = (p.x, p.y)
    distance = math.hypot(p.x - start[0], p.y - start[1])


rospy.init_node('two_meters')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, cb)
twist = Twist()
while not rospy.is_shutdown():
    twist.linear.x = 0.2 if distance < 2.0 else 0.0
    pub.publish(twist)
