#!/usr/bin/env python3
"""Right, but for a topic that only a TurtleBot 2 knows."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


class Rotate(object):
    def __init__(self):
        self.yaw = None
        rospy.on_shutdown(self.stop)
        self.pub = rospy.Publisher('/cmd_vel_mux/input/teleop', Twist, queue_size=5)
        rospy.Subscriber('/odom', Odometry, self.odom)

    def odom(self, m):
        q = m.pose.pose.orientation
        self.yaw = euler_from_quaternion((q.x, q.y, q.z, q.w))[2]

    def stop(self):
        self.pub.publish(Twist())
        rospy.sleep(0.2)

    def run(self):
        r = rospy.Rate(10)
        while not rospy.is_shutdown():
            if self.yaw is not None:
                e = math.pi / 2 - self.yaw
                cmd = Twist()
                cmd.angular.z = 0.6 * math.atan2(math.sin(e), math.cos(e))
                self.pub.publish(cmd)
            r.sleep()


rospy.init_node('rotate')
Rotate().run()
