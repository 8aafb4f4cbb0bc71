#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

yaw = None


def on_odom(msg):
    global yaw
    o = msg.pose.pose.orientation
    yaw = math.asin(2 * (o.w * o.z + o.x * o.y))


rospy.init_node('rotate')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, on_odom)
rate = rospy.Rate(10)
while yaw is None and not rospy.is_shutdown():
    rate.sleep()
while not rospy.is_shutdown():
    error = math.pi / 2 - yaw
    cmd = Twist()
    cmd.angular.z = 0.5 * math.atan2(math.sin(error), math.cos(error))
    pub.publish(cmd)
    rate.sleep()
