#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


class Rotate:
    def __init__(self):
        self.yaw = None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(lambda: self.pub.publish(Twist()))
        rospy.Subscriber('odom', Odometry, self.odom)
        rospy.Timer(rospy.Duration(0.1), self.control)

    def odom(self, msg):
        q = msg.pose.pose.orientation
        self.yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]

    def control(self, _event):
        if self.yaw is None:
            return
        error = math.pi / 2 - self.yaw
        cmd = Twist()
        cmd.angular.z = 0.7 * math.atan2(math.sin(error), math.cos(error))
        self.pub.publish(cmd)


rospy.init_node('rotate')
Rotate()
rospy.spin()
