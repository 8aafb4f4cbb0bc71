#!/usr/bin/env python3
"""One speed, with a window that is wider than a step at any rate; stops and exits."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = None


def cb(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


def error():
    return (math.pi / 2 - yaw + math.pi) % (2 * math.pi) - math.pi


rospy.init_node('bang_bang')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('/odom', Odometry, cb)
rate = rospy.Rate(10)
try:
    while yaw is None:
        rate.sleep()
    while abs(error()) > 0.04:
        cmd = Twist()
        cmd.angular.z = math.copysign(0.2, error())
        pub.publish(cmd)
        rate.sleep()
except rospy.ROSInterruptException:
    pass
pub.publish(Twist())
rospy.rostime.wallsleep(0.3)
