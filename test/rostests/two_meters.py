#!/usr/bin/env python3
"""The first tutorial as a whole: the robot drives two metres and stops."""

import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from odometry_tests.tutorial import Truth, heading, speed
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64


class TwoMetersTest(unittest.TestCase):
    """Given a robot, a detector and a mover, the robot moves two metres."""

    @classmethod
    def setUpClass(cls):
        """Wait until the robot has arrived and stands."""
        cls.moved, cls.commands = Recorder('moved_distance', Float64), Recorder('cmd_vel', Twist)
        cls.truth = Truth()
        cls.moved.wait_for(lambda m: m.data >= 2.0, 40.0, 'two metres')
        cls.truth.clear()
        cls.place = cls.truth.wait_for(lambda m: speed(m) == 0, what='rest').pose

    def test_it_moves_two_metres_and_a_centimetre_at_most(self):
        """As the detector counts it."""
        self.assertTrue(2.0 <= self.moved.last.data <= 2.01, self.moved.last)

    def test_it_is_where_it_believes_to_be(self):
        """Straight ahead in the world."""
        truth = self.truth.last
        self.assertAlmostEqual(truth.pose.pose.position.x, self.moved.last.data, delta=0.001)
        self.assertAlmostEqual(truth.pose.pose.position.y, 0.0, delta=0.002)
        self.assertAlmostEqual(heading(truth), 0.0, delta=0.1)

    def test_it_is_at_rest_afterwards(self):
        """For five seconds of its time neither place nor distance changes, to the bit."""
        distance = self.moved.last
        for recorder in self.moved, self.truth, self.commands:
            recorder.clear()
        self.assertEqual({m.data for m in self.moved.wait_for_count(100)}, {distance.data})
        self.assertTrue(all(m.pose == self.place for m in self.truth.wait_for_count(100)))
        self.assertTrue(all(m == Twist() for m in self.commands.wait_for_count(100)))


if __name__ == '__main__':
    rospy.init_node('two_meters_test', disable_rostime=True)
    rostest.rosrun('odometry_tests', 'two_meters', TwoMetersTest, sys.argv)
