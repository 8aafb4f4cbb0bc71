#!/usr/bin/env python3
"""What main.py, the node that prints headings, promises."""

import math
import unittest

import rospy
from geometry_msgs.msg import Quaternion
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry
from odometry_tests.partners import NodeLog, SteppedClock
from odometry_tests.processes import rosrun
from odometry_tests.rostests import run_rostest
from odometry_tests.waiting import wait_for_subscribers, wait_until
from tf.transformations import quaternion_from_euler


class HeadingPrinterTest(unittest.TestCase):
    """Given odometry, the printer prints what the tutorial shows."""

    @classmethod
    def setUpClass(cls):
        """Start the printer."""
        cls.log = NodeLog()
        cls.odometry = rospy.Publisher('odom', Odometry, queue_size=1000)
        cls.printer = rosrun('rotate_robot', 'main.py')
        cls.addClassCleanup(cls.printer.__exit__)
        cls.clock = SteppedClock(1)
        wait_for_subscribers(cls.odometry)

    def setUp(self):
        """Look only at what is printed from now on."""
        self.first = len(self.printer.stdout.splitlines())

    def test_it_prints_each_yaw_in_radians(self):
        """One line for each message, from a robot that may lean, and nothing else."""
        orientations = [(0.1, -0.2, 0.01 * step - 3.0) for step in range(600)]
        for angles in orientations:
            self.show(Quaternion(*quaternion_from_euler(*angles)))
        wait_until(lambda: len(self.yaws()) >= len(orientations), 10.0, self.printed)
        self.assertEqual(len(self.yaws()), len(orientations))
        for yaw, angles in zip(self.yaws(), orientations):
            self.assertAlmostEqual(yaw, angles[2])

    def test_it_prints_the_quaternion_once_a_second(self):
        """That of the last message, whose length is one again."""
        begin = self.clock.now
        self.show(Quaternion(z=3.0, w=4.0))
        wait_until(self.yaws, 10.0, self.printed)
        wait_until(lambda: self.clock.advance(0.5) or self.quaternions(), 10.0, self.printed)
        before = len(self.quaternions())
        for count in range(1, 6):
            self.clock.advance(*[0.1] * 10)
            wait_until(lambda goal=before + count: len(self.quaternions()) >= goal, 10.0,
                       self.printed)
        # One is due at the beginning, and one may have been on its way then.
        most = (self.clock.now - begin).to_sec() + 2
        self.assertLessEqual(len(self.quaternions()), most)
        for numbers in self.quaternions():
            self.assertEqual([round(number, 6) for number in numbers], [0.0, 0.0, 0.6, 0.8])

    def test_a_quaternion_that_is_no_rotation_is_ignored_and_warned_of(self):
        """The next good one is printed."""
        for quaternion in Quaternion(), Quaternion(w=math.nan):
            self.show(quaternion)
        self.odometry.publish(odometry(yaw=1.25))
        wait_until(self.yaws, 10.0, self.printed)
        self.assertEqual([round(yaw, 9) for yaw in self.yaws()], [1.25])
        self.log.wait_for_warning('/my_quaternion_to_euler', 'is no rotation')

    def show(self, quaternion):
        """Publish odometry with this orientation."""
        message = odometry()
        message.pose.pose.orientation = quaternion
        self.odometry.publish(message)

    def printed(self):
        """Return the end of what was printed."""
        return f'the expected lines; it printed:\n{self.printer.output[-1000:]}'

    def yaws(self):
        """Return the yaws printed (rad)."""
        return [float(line) for line in self.lines() if not line.startswith('[')]

    def quaternions(self):
        """Return the quaternions printed, each a list of x, y, z, w."""
        return [list(map(float, line.strip('[]').split())) for line in self.lines()
                if line.startswith('[')]

    def lines(self):
        """Return what was printed to stdout during the test so far."""
        return self.printer.stdout.splitlines()[self.first:]


if __name__ == '__main__':
    run_rostest('heading_printer', HeadingPrinterTest, disable_rostime=True)
