#!/usr/bin/env python3
"""Two robots beside each other, each with its own detector and mover."""

import unittest

from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, speed

ROBOTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # namespace: start (m) to the left


class RobotsTest(unittest.TestCase):
    """Given two robots, both drive two metres."""

    def test_both_drive_two_metres(self):
        distances = {name: Distance(name) for name in ROBOTS}
        truths = {name: Truth(name) for name in ROBOTS}
        for name, left in ROBOTS.items():
            with self.subTest(name=name):
                moved = distances[name].wait_until_arrived(2.0)
                self.assertTrue(2.0 <= moved <= 2.01, moved)
                truths[name].clear()
                place = truths[name].wait_for(lambda m: speed(m) == 0, what='rest')
                position = place.pose.pose.position
                self.assertAlmostEqual(position.x, moved, delta=0.001)
                self.assertAlmostEqual(position.y, left, delta=0.002)


if __name__ == '__main__':
    run_rostest('robots', RobotsTest, disable_rostime=True)
