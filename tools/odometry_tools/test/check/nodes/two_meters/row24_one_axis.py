#!/usr/bin/env python3
import rospy
from nav_msgs.msg import Odometry
from geometry_msgs.msg import Twist

start_x = None


def cb(odom):
    global start_x
    x = odom.pose.pose.position.x
    if start_x is None:
        start_x = x
    cmd = Twist()
    cmd.linear.x = 0.2 if abs(x - start_x) < 2.0 else 0.0
    pub.publish(cmd)


rospy.init_node('two_meters')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
rospy.Subscriber('odom', Odometry, cb)
rospy.spin()
