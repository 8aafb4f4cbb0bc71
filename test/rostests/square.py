#!/usr/bin/env python3
"""A square driven by time, as many public clients drive it: publish, sleep, and count."""

import math
import unittest

import rospy
from odometry_common.geometry import yaw_of
from odometry_tests.punctual_rate import PunctualRate
from odometry_tests.robots import Robot
from odometry_tests.rostests import run_rostest
from odometry_tests.simulation import Simulation

LEGS = [(0.2, 0.0, 2.5), (0.0, math.pi / 4, 2.0)] * 4  # m/s, rad/s, s
BEGIN = 1.0  # s; at time zero rospy does not know yet that there is a clock
STOPPING = 1.0  # s
NEAR, STRAIGHT = 0.03, 1.0  # m, degrees


class SquareTest(unittest.TestCase):
    """Given a client that sleeps on the clock, the robot ends where it would on a perfect clock."""

    def test_it_ends_where_perfect_timing_leads_it(self):
        """Compared with the same commands at the very times at which they are due."""
        rate = rospy.get_param('~rate')
        robot, expected = Robot(), Simulation(odom_rate=100.0 if rate > 20 else 20.0)
        self.answer_until(robot, BEGIN)
        # The clock, on a connection of its own, may be heard after the odometry.
        loop = PunctualRate(rate, robot.odometry.last.header.stamp)
        for linear, angular, duration in [*LEGS, (0.0, 0.0, STOPPING)]:
            for _ in range(round(duration * rate)):
                robot.drive(linear, angular)
                loop.sleep()
            self.assertAlmostEqual(rospy.get_time(), loop.due.to_sec(), delta=1.5 / rate)
            expected.drive(linear, angular, duration)
        place = robot.truth.wait_for(lambda m: m.header.stamp >= loop.due).pose.pose
        perfect = expected.robot.ground_truth
        self.assertLess(math.dist((place.position.x, place.position.y), perfect.position[:2]), NEAR)
        turned = yaw_of((0.0, 0.0, place.orientation.z, place.orientation.w))
        apart = math.degrees(math.remainder(turned - yaw_of(perfect.orientation), 2 * math.pi))
        self.assertLess(abs(apart), STRAIGHT)

    def answer_until(self, robot, time):
        """Answer each odometry with zero until the robot's time (s) has come."""
        robot.wait_until_ready()
        while robot.odometry.last.header.stamp.to_sec() < time:
            seen = len(robot.odometry.messages)
            robot.drive(0.0)
            robot.odometry.wait_for_count(seen + 1)


if __name__ == '__main__':
    run_rostest('square', SquareTest)
