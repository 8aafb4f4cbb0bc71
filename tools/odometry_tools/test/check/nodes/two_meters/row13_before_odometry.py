#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

x = y = 0.0


def odom(msg):
    global x, y
    x = msg.pose.pose.position.x
    y = msg.pose.pose.position.y


rospy.init_node('drive')
rospy.Subscriber('odom', Odometry, odom)
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
x0, y0 = x, y
rate = rospy.Rate(10)
while not rospy.is_shutdown() and math.sqrt((x - x0) ** 2 + (y - y0) ** 2) < 2:
    t = Twist()
    t.linear.x = 0.2
    pub.publish(t)
    rate.sleep()
pub.publish(Twist())
rospy.sleep(1)
