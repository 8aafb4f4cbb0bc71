#!/usr/bin/env python3
import copy
import math
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry

rospy.init_node('drive')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.on_shutdown(lambda: pub.publish(Twist()))
start = rospy.wait_for_message('odom', Odometry).pose.pose.position
position = copy.deepcopy(start)
rate = rospy.Rate(10)
while math.hypot(position.x - start.x, position.y - start.y) < 2.0 and not rospy.is_shutdown():
    cmd = Twist()
    cmd.linear.x = 0.3
    pub.publish(cmd)
    rate.sleep()
