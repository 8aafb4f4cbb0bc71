#!/usr/bin/env python3
"""The second tutorial as a whole: the robot turns to a heading."""

import unittest

from nav_msgs.msg import Odometry
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import heading
from odometry_tests.waiting import Recorder

TARGET = -90.0  # degrees
PRECISION = 0.1  # degrees


class TurnsTest(unittest.TestCase):
    """Given a target, the robot turns to it and stays there."""

    def test_it_turns_to_its_target_and_settles(self):
        """For a second of its time."""
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: abs(heading(m) - TARGET) < PRECISION, what='the heading')
        odometry.clear()
        for message in odometry.wait_for_count(20):
            self.assertAlmostEqual(heading(message), TARGET, delta=PRECISION)


if __name__ == '__main__':
    run_rostest('turns', TurnsTest, disable_rostime=True)
