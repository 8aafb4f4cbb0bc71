#!/usr/bin/env python3
"""Nodes that use tf find the robot, and find it again after the simulator's reset."""

import unittest

import tf
from odometry_tests.pausing import call
from odometry_tests.robots import Robot
from odometry_tests.rostests import run_rostest
from odometry_tests.waiting import wait_until


class TfUsersTest(unittest.TestCase):
    """Given a reset in mid-drive, tf's users are not left with what was before."""

    def setUp(self):
        """Look at the robot by tf alone."""
        self.listener = tf.TransformListener()
        self.robot = Robot()
        self.robot.wait_until_ready()

    def test_tf_follows_the_robot_through_a_reset(self):
        """It knows the latest pose, then the start, and then the latest pose again."""
        self.robot.drive(0.5)
        self.wait_for(lambda stamp, x: stamp > 4 and x > 1, 'a robot on its way')
        call('reset_simulation')
        self.wait_for(lambda _, x: x == 0, 'a robot at its start')
        self.robot.drive(0.5)
        self.wait_for(lambda stamp, x: 0.5 < x < stamp, 'a robot on its way once more')

    def wait_for(self, accepts, what):
        """Return once the stamp (s) and x (m) of the latest transform are accepted."""
        def accepted():
            try:
                stamp = self.listener.getLatestCommonTime('odom', 'base_footprint')
                (x, _, _), _ = self.listener.lookupTransform('odom', 'base_footprint', stamp)
            except tf.Exception:
                return False
            return accepts(stamp.to_sec(), x)
        wait_until(accepted, 20.0, what)


if __name__ == '__main__':
    run_rostest('tf_users', TfUsersTest)
