#!/usr/bin/env python3
import rospy
import math
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = None


def cb(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('rotate')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.Subscriber('/odom', Odometry, cb)
while not rospy.is_shutdown():
    if yaw is None:
        continue
    e = math.radians(90) - yaw
    e = math.atan2(math.sin(e), math.cos(e))
    t = Twist()
    t.angular.z = 0.5 * e
    pub.publish(t)
pub.publish(Twist())
