"""How the script of a rostest begins."""

import sys

import rospy
import rostest
from odometry_common.rospy_fixes import fix_rospy


def run_rostest(name, case, **init_node_options):
    """Join the graph as the node NAME_test, run a unittest.TestCase for rostest, and exit."""
    fix_rospy()
    rospy.init_node(f'{name}_test', **init_node_options)
    rostest.rosrun('odometry_tests', name, case, sys.argv)
