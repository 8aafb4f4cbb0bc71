#!/usr/bin/env python3
"""Says why it gives up, and ends with a status; what it printed before is no error of Python."""
import os
import sys
import rospy

rospy.init_node('gives_up')
print('Error: 1.57', os.environ['ROS_MASTER_URI'])
print('\033[31mno gyro at 0x7f0011223344, giving up\033[0m')
sys.exit(2)
