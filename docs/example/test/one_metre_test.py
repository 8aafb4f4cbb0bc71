#!/usr/bin/env python3
"""The position of the robot after ten simulated seconds."""

import sys
import threading
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry

LOOK_AT = 10.0  # simulated s; a metre takes five
TIMEOUT = 60.0  # s of wall time


class OneMetreTest(unittest.TestCase):
    """Given the robot, the node drives it one metre."""

    def setUp(self):
        """Subscribe to the true pose."""
        self.last = None
        self.time_is_up = threading.Event()
        rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_odometry)

    def on_odometry(self, message):
        """Keep the first message at or after LOOK_AT."""
        if not self.time_is_up.is_set():
            self.last = message
            if message.header.stamp.to_sec() >= LOOK_AT:
                self.time_is_up.set()

    def test_the_robot_stands_one_metre_ahead(self):
        """It overshoots by up to 3 cm in a tenth of a second at 0.2 m/s and while braking."""
        self.assertTrue(self.time_is_up.wait(TIMEOUT), f'time stands still:\n{self.last}')
        self.assertAlmostEqual(self.last.pose.pose.position.x, 1.015, delta=0.015)
        self.assertEqual(self.last.twist.twist.linear.x, 0.0)


if __name__ == '__main__':
    rospy.init_node('one_metre_test')
    rostest.rosrun('one_metre', 'one_metre', OneMetreTest, sys.argv)
