#!/usr/bin/env python3
"""The first tutorial as a whole: two robots beside each other, each with its own detector and mover."""

import unittest

from geometry_msgs.msg import Twist
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Distance, Truth, heading, speed
from odometry_tests.waiting import Recorder

ROBOTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # namespace: start (m) to the left


class RobotsTest(unittest.TestCase):
    """Given two robots, both drive two metres and stop."""

    def test_both_drive_two_metres_and_stay_there(self):
        """Straight ahead, as each detector counts it; at rest for five seconds of their time."""
        distances = {name: Distance(name) for name in ROBOTS}
        truths = {name: Truth(name) for name in ROBOTS}
        commands = {name: Recorder(f'{name}cmd_vel', Twist) for name in ROBOTS}
        for name, left in ROBOTS.items():
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
                self.assertEqual({str(m.pose) for m in truths[name].wait_for_count(100)}, {str(place.pose)})
                self.assertEqual({str(m) for m in commands[name].wait_for_count(100)}, {str(Twist())})


if __name__ == '__main__':
    run_rostest('robots', RobotsTest, disable_rostime=True)
