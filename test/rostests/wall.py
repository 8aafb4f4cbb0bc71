#!/usr/bin/env python3
"""Wheels that slip before a wall: odometry counts a path that the robot has not taken."""

import unittest

from nav_msgs.msg import Odometry
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, speed
from odometry_tests.waiting import Recorder

START = 1.0  # m, where the robot begins
WALL = 2.0  # m, the face of the wall
RADIUS = 0.18  # m, of the robot
DISTANCE = 1.5  # m, which it is told to go


class WallTest(unittest.TestCase):
    """Given a wall in its path, the robot is stopped, and its encoders are not."""

    def test_the_encoders_count_on_before_the_wall(self):
        """The whole distance; the robot itself stands where it touches the wall."""
        odometry, truth = Recorder('odom', Odometry), Truth()
        moved = Distance().wait_until_arrived(DISTANCE)
        truth.clear()
        place = truth.wait_for(lambda m: speed(m) < 0.01, what='rest').pose.pose.position
        self.assertAlmostEqual(place.x, WALL - RADIUS, delta=0.05)
        self.assertLess(moved, DISTANCE + 0.02)
        believed = odometry.last.pose.pose.position.x
        self.assertGreater(believed, place.x - START + 0.5)


if __name__ == '__main__':
    run_rostest('wall', WallTest, disable_rostime=True)
