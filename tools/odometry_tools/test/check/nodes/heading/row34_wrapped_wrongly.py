#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion


def callback(msg):
    q = msg.pose.pose.orientation
    yaw = euler_from_quaternion([q.x, q.y, q.z, q.w])[2]
    if yaw < 0:
        yaw = yaw + math.pi      # 0 to 360
    error = math.radians(90) - yaw
    cmd = Twist()
    cmd.angular.z = 0.5 * error
    pub.publish(cmd)


rospy.init_node('rotate')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('/odom', Odometry, callback)
rospy.spin()
