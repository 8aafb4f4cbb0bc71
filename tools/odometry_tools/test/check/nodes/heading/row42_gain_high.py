#!/usr/bin/env python3
from math import pi, atan2, sin, cos
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

Kp = 10


def control(msg):
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]
    e = pi / 2 - yaw
    cmd = Twist()
    cmd.angular.z = Kp * atan2(sin(e), cos(e))
    pub.publish(cmd)


rospy.init_node('p_controller')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, control)
rospy.spin()
