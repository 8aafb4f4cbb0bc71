#!/usr/bin/env python3
"""The first tutorial as a whole, with two robots beside each other: they drive two metres and stop."""

import unittest

from geometry_msgs.msg import Twist
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, heading, speed
from odometry_tests.waiting import Recorder

ROBOTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # namespace: start (m) to the left


class RobotsTest(unittest.TestCase):
    """Given two robots, each with its own detector and mover, both move two metres."""

    def test_both_drive_two_metres(self):
        """And a centimetre at most; each is where it believes it is."""
        recorders = {name: (Distance(name), Truth(name), Recorder(f'{name}cmd_vel', Twist))
                     for name in ROBOTS}
        for name, left in ROBOTS.items():
            with self.subTest(name=name):
                distance, truth, commands = recorders[name]
                moved = distance.wait_until_arrived(2.0)
                self.assertTrue(2.0 <= moved <= 2.01, moved)
                truth.clear()
                place = truth.wait_for(lambda m: speed(m) == 0, what='rest')
                position = place.pose.pose.position
                self.assertAlmostEqual(position.x, moved, delta=0.001)
                self.assertAlmostEqual(position.y, left, delta=0.002)
                self.assertAlmostEqual(heading(place), 0.0, delta=0.1)
                self.assert_rest(place, truth, commands)

    def assert_rest(self, place, truth, commands):
        """For five seconds of its time: commanded to stand, and in its place to the bit."""
        for recorder in truth, commands:
            recorder.clear()
        self.assertTrue(all(m.pose == place.pose for m in truth.wait_for_count(100)))
        self.assertTrue(all(m == Twist() for m in commands.wait_for_count(100)))


if __name__ == '__main__':
    run_rostest('robots', RobotsTest, disable_rostime=True)
