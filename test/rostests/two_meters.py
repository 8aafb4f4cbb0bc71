#!/usr/bin/env python3
"""The first tutorial: robot, detector and mover together go two metres."""

import sys
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

TIMEOUT = 120.0  # s of wall time
RESTS = 100  # odometry messages; five simulated seconds


class TwoMetersTest(unittest.TestCase):
    """Given the launch file of the first tutorial."""

    def setUp(self):
        """Follow the true pose and the distance."""
        self.truth, self.moved = [], 0.0
        self.rests = threading.Event()
        rospy.Subscriber('moved_distance', Float64, self.on_distance)
        rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_truth)

    def on_distance(self, message):
        """Keep the latest distance."""
        self.moved = message.data

    def on_truth(self, message):
        """Keep each pose, until the robot has moved and then rested."""
        self.truth.append(message)
        is_at_rest = all(seen.twist.twist == Twist() for seen in self.truth[-RESTS:])
        if message.pose.pose.position.x > 1.0 and is_at_rest:
            self.rests.set()

    def test_the_robot_stops_two_metres_ahead(self):
        """Straight ahead; it overshoots by up to 1 cm, and the detector counts where it really is."""
        self.assertTrue(self.rests.wait(TIMEOUT), f'no rest, {self.moved} m moved:\n{self.truth[-1:]}')
        end = self.truth[-1].pose.pose.position
        self.assertTrue(2.0 <= self.moved <= 2.01, self.moved)
        self.assertAlmostEqual(end.x, self.moved, delta=0.001)
        self.assertAlmostEqual(end.y, 0.0, delta=0.002)


if __name__ == '__main__':
    rospy.init_node('two_meters_test')
    rostest.rosrun('odometry_tests', 'two_meters', TwoMetersTest, sys.argv)
