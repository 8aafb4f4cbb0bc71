#!/usr/bin/env python3
"""Stops a degree early, which is fine."""
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

yaw = None


def odom(msg):
    global yaw
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]


rospy.init_node('turn')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, odom)
rate = rospy.Rate(10)
try:
    while not rospy.is_shutdown():
        if yaw is not None:
            e = math.atan2(math.sin(math.pi / 2 - yaw), math.cos(math.pi / 2 - yaw))
            speed = 0.5 * e
            cmd = Twist()
            if int(speed * 100) == 0:
                pub.publish(cmd)
                break
            cmd.angular.z = speed
            pub.publish(cmd)
        rate.sleep()
    rospy.spin()
except rospy.ROSInterruptException:
    pass
