#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from math import pi
from tf.transformations import euler_from_quaternion


class Turner:
    def __init__(self):
        self.pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        self.sub = rospy.Subscriber('/odom', Odometry, self.callback)

    def callback(self, data):
        o = data.pose.pose.orientation
        (_, _, yaw) = euler_from_quaternion([o.x, o.y, o.z, o.w])
        t = Twist()
        t.angular.z = 0.5 * (pi / 2 - yaw)
        self.pub.piblish(t)


rospy.init_node('turner')
Turner()
rospy.spin()
