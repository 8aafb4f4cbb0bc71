#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = None


def odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = math.degrees(euler_from_quaternion([q.x, q.y, q.z, q.w])[2])


rospy.init_node('turn')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(10)
while yaw is None:
    rate.sleep()
start = yaw
to_turn = (90 - start + 180) % 360 - 180
twist = Twist()
while abs(yaw - start) < abs(to_turn) and not rospy.is_shutdown():
    twist.angular.z = math.copysign(0.3, to_turn)
    pub.publish(twist)
    rate.sleep()
pub.publish(Twist())
rospy.sleep(1)
