"""Pass Odometry on from one topic to another, with nothing in between: the limit of latency."""

import sys

import rospy
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise

rospy.init_node('relay', anonymous=True)
question, answer = sys.argv[1:3]
rospy.Subscriber(question, Odometry, advertise(answer, Odometry).publish, tcp_nodelay=True)
print('ready', flush=True)
rospy.spin()
