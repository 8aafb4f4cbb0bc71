#!/usr/bin/env python3
"""A PI controller, which overshoots once and settles."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


class PI(object):
    kp, ki = 1.0, 0.15

    def __init__(self):
        self.sum, self.stamp = 0.0, None
        self.pub = rospy.Publisher('cmd_vel', Twist, queue_size=2)
        rospy.on_shutdown(self.halt)
        self.sub = rospy.Subscriber('odom', Odometry, self.step)

    def halt(self):
        self.sub.unregister()
        self.pub.publish(Twist())

    def step(self, msg):
        q, now = msg.pose.pose.orientation, msg.header.stamp.to_sec()
        e = math.remainder(math.pi / 2 - euler_from_quaternion([q.x, q.y, q.z, q.w])[2], 2 * math.pi)
        if self.stamp is not None and abs(e) < 0.5:
            self.sum += e * (now - self.stamp)
        self.stamp = now
        out = Twist()
        out.angular.z = max(-1.0, min(1.0, self.kp * e + self.ki * self.sum))
        self.pub.publish(out)


rospy.init_node('pi')
PI()
rospy.spin()
