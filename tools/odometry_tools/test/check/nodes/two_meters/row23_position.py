#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from geometry_msgs.msg import Twist


def cb(odom):
    cmd = Twist()
    if odom.pose.pose.position.x < 2.0:
        cmd.linear.x = 0.2
    pub.publish(cmd)


rospy.init_node('two_meters')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
