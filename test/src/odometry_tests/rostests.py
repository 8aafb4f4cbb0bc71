"""How a test joins the ROS graph."""

import sys

import rospy
import rostest
from odometry_common.rospy_fixes import fix_rospy
from odometry_common.transport import wait_for_slow_subscribers

from odometry_tests.waiting import PATIENCE, TIMEOUT


def join(name, **init_node_options):
    """Become a node that, unlike the nodes under test, waits for slow subscribers."""
    fix_rospy()
    wait_for_slow_subscribers(TIMEOUT * PATIENCE)
    rospy.init_node(name, **init_node_options)


def run_rostest(name, case, **init_node_options):
    join(f'{name}_test', **init_node_options)
    rostest.rosrun('odometry_tests', name, case, sys.argv)
