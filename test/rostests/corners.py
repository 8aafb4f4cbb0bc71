#!/usr/bin/env python3
"""A controller as TurtleBot 2's clients have it: base_link from tf, commands to the multiplexer."""

import math
import unittest

import rospy
import tf
from geometry_msgs.msg import Twist
from odometry_tests.punctual_rate import PunctualRate
from odometry_tests.robots import twist
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import Truth, heading
from odometry_tests.waiting import TIMEOUT, wait_for_subscribers, wait_until

RATE = 20  # Hz
CORNERS = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]  # m, in odom
SPEED, TURN_SPEED = 0.25, 0.8  # m/s, rad/s; at most
SLOWEST = 0.1  # of each, near the goal
BRAKING = 10  # periods
SOON = 0.001  # s between two looks at tf
CLOSE, AIMED = 0.01, math.radians(0.5)  # m, rad; what the controller takes for there
PRECISION, ANGULAR_PRECISION = 0.03, 1.0  # m, degrees; what the issue allows


class CornerClient:
    """Drives from corner to corner, and turns on each."""

    def __init__(self, truth):
        """Find the robot; from then on answer each moment of its time once."""
        self._listener = tf.TransformListener()
        self._publisher = rospy.Publisher('cmd_vel_mux/input/navi', Twist, queue_size=1)
        wait_for_subscribers(self._publisher)
        begin = truth.wait_for().header.stamp
        while not (rospy.get_time() > 0 and self._knows(begin)):
            self._publisher.publish(twist(0.0))
            begin = truth.wait_for(lambda m, last=begin: m.header.stamp > last).header.stamp
        self._rate = PunctualRate(RATE, begin)

    @property
    def now(self):
        """The time up to which it has commanded: it stands still until the next command."""
        return self._rate.due

    def drive_to(self, x, y):
        """Return once the robot is there."""
        while True:
            (here_x, here_y), yaw = self._pose()
            distance = math.hypot(x - here_x, y - here_y)
            if distance < CLOSE:
                return self.stand()
            aside = wrap(math.atan2(y - here_y, x - here_x) - yaw)
            if abs(aside) > math.pi / 2:  # it has passed
                return self.stand()
            self._move(max(SLOWEST, min(SPEED, distance)), aside if distance > 0.1 else 0.0)

    def turn_to(self, yaw):
        """Return once the robot looks there."""
        while True:
            error = wrap(yaw - self._pose()[1])
            if abs(error) < AIMED:
                return self.stand()
            self._move(0.0, math.copysign(max(SLOWEST, min(TURN_SPEED, abs(error))), error))

    def stand(self):
        """Return once the robot has had time to stop."""
        for _ in range(BRAKING):
            self._move(0.0, 0.0)

    def _pose(self):
        """Return the place and yaw now: tf may be heard after the clock."""
        wait_until(lambda: self._knows(self.now), TIMEOUT, f'tf at {self.now.to_sec():g} s', SOON)
        position, rotation = self._listener.lookupTransform('odom', 'base_link', self.now)
        return position[:2], tf.transformations.euler_from_quaternion(rotation)[2]

    def _move(self, linear, angular):
        self._publisher.publish(twist(linear, angular))
        self._rate.sleep()

    def _knows(self, time):
        return self._listener.canTransform('odom', 'base_link', time)


class CornersTest(unittest.TestCase):
    """Given the frames and the inputs of a TurtleBot 2, such a client gets where it wants to."""

    def test_it_ends_where_it_began(self):
        """And stands on each corner on the way, in truth and not just by its own account."""
        truth = Truth()
        truth.wait_for_publisher()
        client = CornerClient(truth)
        for number, corner in enumerate(CORNERS, 1):
            client.drive_to(*corner)
            client.turn_to(number * math.pi / 2)
            there = truth.wait_for(lambda m: m.header.stamp >= client.now)
            place = there.pose.pose.position
            self.assertLess(math.dist((place.x, place.y), corner), PRECISION)
            off = math.remainder(heading(there) - number * 90.0, 360.0)
            self.assertLess(abs(off), ANGULAR_PRECISION)


def wrap(angle):
    """Return the same angle (rad) between -pi and pi."""
    return math.remainder(angle, 2 * math.pi)


if __name__ == '__main__':
    run_rostest('corners', CornersTest)
