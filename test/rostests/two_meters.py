#!/usr/bin/env python3
"""The first tutorial as a whole: each robot drives two metres and stops."""

import unittest

from geometry_msgs.msg import Twist
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, heading, speed
from odometry_tests.waiting import Recorder

STARTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # by namespace: m to the left


class TwoMetersTest(unittest.TestCase):
    """Given two robots, each with a detector and a mover, both move two metres."""

    def test_each_moves_two_metres_and_stays_there(self):
        """Straight ahead, as its detector counts it; at rest for five seconds of their time."""
        distances = {name: Distance(name) for name in STARTS}
        truths = {name: Truth(name) for name in STARTS}
        commands = {name: Recorder(f'{name}cmd_vel', Twist) for name in STARTS}
        for name, left in STARTS.items():
            with self.subTest(name=name):
                moved = distances[name].wait_until_arrived(2.0)
                self.assertTrue(2.0 <= moved <= 2.01, moved)
                truths[name].clear()
                place = truths[name].wait_for(lambda m: speed(m) == 0, what='rest')
                position = place.pose.pose.position
                self.assertAlmostEqual(position.x, moved, delta=0.001)
                self.assertAlmostEqual(position.y, left, delta=0.002)
                self.assertAlmostEqual(heading(place), 0.0, delta=0.1)
                for recorder in truths[name], commands[name]:
                    recorder.clear()
                self.assertTrue(all(m.pose == place.pose for m in truths[name].wait_for_count(100)))
                self.assertTrue(all(m == Twist() for m in commands[name].wait_for_count(100)))


if __name__ == '__main__':
    run_rostest('two_meters', TwoMetersTest, disable_rostime=True)
