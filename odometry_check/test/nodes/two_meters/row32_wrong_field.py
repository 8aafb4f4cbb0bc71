#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Float64

rospy.init_node('sideways')
pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
rospy.Subscriber('moved_distance', Float64,
                 lambda m: pub.publish(Twist(linear=Vector3(0, 0.1 if m.data < 2 else 0, 0))))
rospy.spin()
