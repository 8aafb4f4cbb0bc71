#!/usr/bin/env python3
import math
import rospy
from geometry_msgs.msg import Twist

target = float(input('Angle in degrees: '))
rospy.init_node('rotate')
pub = rospy.Publisher('/cmd_vel', Twist, queue_size=1)
rate = rospy.Rate(10)
while not rospy.is_shutdown():
    t = Twist()
    t.angular.z = math.radians(target) / 10
    pub.publish(t)
    rate.sleep()
