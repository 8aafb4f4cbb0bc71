#!/usr/bin/env python3
"""The first tutorial as a whole: the robot drives two metres and stops."""

import unittest

from geometry_msgs.msg import Twist
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, heading, speed
from odometry_tests.waiting import Recorder


class TwoMetersTest(unittest.TestCase):
    """Given a robot, a detector and a mover, the robot moves two metres."""

    @classmethod
    def setUpClass(cls):
        """Wait until the robot has arrived and stands."""
        moved, cls.ground_truth = Distance(), Truth()
        cls.commands = Recorder('cmd_vel', Twist)
        cls.distance = moved.wait_until_arrived(2.0)
        cls.ground_truth.clear()
        cls.place = cls.ground_truth.wait_for(lambda m: speed(m) == 0, what='rest')

    def test_it_moves_two_metres_and_a_centimetre_at_most(self):
        """As the detector counts it; then the distance stays the same to the bit."""
        self.assertTrue(2.0 <= self.distance <= 2.01, self.distance)

    def test_it_is_where_it_believes_it_is(self):
        """Straight ahead in the world."""
        position = self.place.pose.pose.position
        self.assertAlmostEqual(position.x, self.distance, delta=0.001)
        self.assertAlmostEqual(position.y, 0.0, delta=0.002)
        self.assertAlmostEqual(heading(self.place), 0.0, delta=0.1)

    def test_it_is_at_rest_afterwards(self):
        """For five seconds of its time: commanded to stand, and in its place to the bit."""
        for recorder in self.ground_truth, self.commands:
            recorder.clear()
        self.assertTrue(all(m.pose == self.place.pose for m in self.ground_truth.wait_for_count(100)))
        self.assertTrue(all(m == Twist() for m in self.commands.wait_for_count(100)))


if __name__ == '__main__':
    run_rostest('two_meters', TwoMetersTest, disable_rostime=True)
