#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = 0.0


def odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('turn')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(10)
while True:
    try:
        e = math.pi / 2 - yaw
        cmd = Twist()
        cmd.angular.z = 0.5 * math.atan2(math.sin(e), math.cos(e))
        pub.publish(cmd)
        rate.sleep()
    except:
        pass
