"""A ROS master for each run of pytest: rospy joins one only once."""

import pytest
import rospy
from odometry_tests.processes import Master


@pytest.fixture(scope='session')
def master():
    """Start a master of its own, with the clock of the wall, and join it as a node."""
    with Master() as process:
        if not rospy.core.is_initialized():
            rospy.init_node('system_test', anonymous=True, disable_signals=True,
                            disable_rostime=True)
        yield process
