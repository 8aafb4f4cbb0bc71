#!/usr/bin/env python3
"""Two robots beside each other, each with its own detector and mover."""

import sys
import unittest

import rospy
import rostest
from odometry_tests.tutorial import Truth, speed
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64

ROBOTS = {'/robot_1/': 0.0, '/robot_2/': 1.0}  # namespace: start (m) to the left


class RobotsTest(unittest.TestCase):
    """Given two robots, both drive two metres."""

    def test_both_drive_two_metres(self):
        """Side by side."""
        moved = {name: Recorder(f'{name}moved_distance', Float64) for name in ROBOTS}
        truths = {name: Truth(name) for name in ROBOTS}
        for name, left in ROBOTS.items():
            moved[name].wait_for(lambda m: m.data >= 2.0, 40.0, 'two metres')
            truths[name].clear()
            place = truths[name].wait_for(lambda m: speed(m) == 0, what='rest').pose.pose.position
            self.assertTrue(2.0 <= moved[name].last.data <= 2.01, moved[name].last)
            self.assertAlmostEqual(place.x, moved[name].last.data, delta=0.001)
            self.assertAlmostEqual(place.y, left, delta=0.002)


if __name__ == '__main__':
    rospy.init_node('robots_test', disable_rostime=True)
    rostest.rosrun('odometry_tests', 'robots', RobotsTest, sys.argv)
