#!/usr/bin/env python3
"""The mover drives until the robot has moved two metres, and stops without a detector."""

import queue
import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64

TIMEOUT = 30.0  # s of wall time


class MoverTest(unittest.TestCase):
    """Given a mover, and distances that this test publishes."""

    def setUp(self):
        """Connect to the mover; it answers each distance with a command."""
        self.commands = queue.Queue()
        rospy.Subscriber('cmd_vel', Twist, self.commands.put)
        self.distance = rospy.Publisher('moved_distance', Float64, queue_size=1)

    def speed_until(self, expected, distance=None):
        """Publish a distance (m), if any, until a command has the expected speed (m/s)."""
        end, command = rospy.get_time() + TIMEOUT, None
        while rospy.get_time() < end:
            if distance is not None:
                self.distance.publish(distance)
            try:
                command = self.commands.get(timeout=0.5)
            except queue.Empty:
                continue  # not connected yet
            if command.linear.x == expected:
                return command
        return self.fail(f'no command of {expected} m/s; the last was:\n{command}')

    def test_it_drives_up_to_two_metres(self):
        """Straight ahead at 0.1 m/s, and then all is zero."""
        for distance in 0.0, 1.0, 1.999:
            self.speed_until(0.1, distance)
        self.assertEqual(self.speed_until(0.0, 2.0), Twist())

    def test_a_detector_that_falls_silent_stops_the_robot(self):
        """A second after the last distance."""
        self.speed_until(0.1, 0.5)
        self.assertEqual(self.speed_until(0.0), Twist())


if __name__ == '__main__':
    rospy.init_node('mover_test')
    rostest.rosrun('odometry_tests', 'mover', MoverTest, sys.argv)
