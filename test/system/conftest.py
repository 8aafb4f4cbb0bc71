"""A ROS master for each file of system tests."""

import pytest
import rospy
from odometry_tests.processes import Master


@pytest.fixture(scope='module')
def master():
    """Start a master of the module's own, with the clock of the wall, and join it as a node."""
    with Master() as process:
        if not rospy.core.is_initialized():
            rospy.init_node('system_test', anonymous=True, disable_signals=True,
                            disable_rostime=True)
        yield process
