#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


class Turn:
    done = False

    def __init__(self):
        self.pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
        rospy.on_shutdown(self.stop)
        rospy.Subscriber('/odom', Odometry, self.odom)

    def stop(self):
        self.pub.publish(Twist())

    def odom(self, msg):
        q = msg.pose.pose.orientation
        yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]
        diff = math.pi / 2 - yaw
        diff = math.atan2(math.sin(diff), math.cos(diff))
        if abs(diff) < 0.03:
            self.done = True
        cmd = Twist()
        if not self.done:
            cmd.angular.z = 0.9
        self.pub.publish(cmd)


rospy.init_node('turn')
Turn()
rospy.spin()
