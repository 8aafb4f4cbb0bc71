#!/usr/bin/env python3
"""Import what the script of a node imports, become a node, see one message, and end.

usage: bare_node.py SCRIPT
"""

import runpy
import sys

import rospy
from std_msgs.msg import Empty

runpy.run_path(sys.argv[1])  # its imports and definitions, but not its main()
rospy.init_node('bare', anonymous=True)
rospy.Publisher('~message', Empty, queue_size=1, latch=True).publish()
rospy.wait_for_message('~message', Empty)
print('seen', flush=True)
