#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

pos = None


def odom(msg):
    global pos
    pos = msg.pose.pose.position


rospy.init_node('go_to_point')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(20)
while pos is None:
    rate.sleep()
goal = (pos.x + 2.0, pos.y)
while not rospy.is_shutdown():
    t = Twist()
    if math.hypot(goal[0] - pos.x, goal[1] - pos.y) > 0.03:
        t.linear.x = 0.2
    pub.publish(t)
    rate.sleep()
