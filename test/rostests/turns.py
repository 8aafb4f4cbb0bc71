#!/usr/bin/env python3
"""The second tutorial as a whole: the robot turns to one heading after another."""

import itertools
import math
import unittest

import rospy
from nav_msgs.msg import Odometry
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import heading
from odometry_tests.waiting import Recorder, wait_for_subscribers
from std_msgs.msg import Float64

START = 35  # degrees
TURNS = {90: 90, -90: -90, 180: 180, 270: -90}  # degrees: the shorter way
PRECISION = 0.1  # degrees
SETTLED = 20  # odometry messages, one second


class TurnsTest(unittest.TestCase):
    """Given a target, the robot turns to it by the shorter way and stays there."""

    @classmethod
    def setUpClass(cls):
        cls.odometry = Recorder('odom', Odometry)
        cls.target = rospy.Publisher('rotate_robot/target', Float64, queue_size=1)
        wait_for_subscribers(cls.target)
        cls.odometry.wait_for()

    def test_it_turns_by_the_shorter_way_and_settles(self):
        """One turn after the other."""
        target = START
        self.turn_to(target)
        for turn, shorter in TURNS.items():
            case = f'{turn} degrees from {target} degrees'
            target += turn
            turned = self.turn_to(target)
            self.assertAlmostEqual(abs(turned[-1]), abs(shorter), delta=2 * PRECISION, msg=case)
            self.assertLessEqual(max(map(abs, turned)), abs(shorter) + 2 * PRECISION, case)
            if turn != 180:
                self.assertGreater(turned[-1] * shorter, 0, case)

    def turn_to(self, target):
        """Turn to a heading (degrees) and stay there; return the angle turned over time (degrees)."""
        start = self.odometry.last
        self.odometry.clear()
        self.target.publish(Float64(target))
        self.odometry.wait_for(lambda m: abs(apart(heading(m), target)) < PRECISION, 20.0,
                               f'a heading of {target} degrees')
        arrived = len(self.odometry.messages)
        seen = self.odometry.wait_for_count(arrived + SETTLED)
        for message in seen[arrived:]:
            self.assertLess(abs(apart(heading(message), target)), PRECISION)
        headings = [heading(message) for message in (start, *seen)]
        return list(itertools.accumulate(map(apart, headings[1:], headings)))


def apart(heading, other):
    """Return how far the first heading is to the left of the other (degrees), at most half a turn."""
    return math.remainder(heading - other, 360.0)


if __name__ == '__main__':
    run_rostest('turns', TurnsTest, disable_rostime=True)
