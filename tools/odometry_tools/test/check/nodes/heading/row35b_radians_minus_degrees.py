#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


class Rotator:
    def __init__(self):
        self.heading = 0.0
        self.target = math.pi / 2
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.Subscriber('odom', Odometry, self.on_odom)
        rospy.Timer(rospy.Duration(0.1), self.control)

    def on_odom(self, msg):
        q = msg.pose.pose.orientation
        self.heading = math.degrees(euler_from_quaternion([q.x, q.y, q.z, q.w])[2])

    def control(self, event):
        cmd = Twist()
        cmd.angular.z = 0.8 * (self.target - self.heading)
        self.pub.publish(cmd)


rospy.init_node('rotator')
Rotator()
rospy.spin()
