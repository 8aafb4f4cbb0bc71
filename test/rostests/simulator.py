#!/usr/bin/env python3
"""What the simulated robot does with commands, and what its services do, over real topics."""

import math
import unittest

from odometry_tests.partners import NodeLog
from odometry_tests.robots import Robot, place
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import REST_SPEED, heading, speed

START = 1.0, -2.0, 1.5  # m, m, rad; where the robot in the corner starts
TOP_SPEED, TOP_TURN = 0.7, math.pi  # m/s, rad/s, TurtleBot 2 specification


class SimulatorTest(unittest.TestCase):
    """Given commands, the robot moves as a TurtleBot 2 does."""

    @classmethod
    def setUpClass(cls):
        """Hear everything from the start on."""
        cls.log = NodeLog()
        cls.alone, cls.corner = Robot('alone/'), Robot('corner/')
        for robot in (cls.alone, cls.corner):
            robot.wait_until_ready()

    def setUp(self):
        """Begin with a robot at rest."""
        self.corner.stop()

    def test_both_velocity_topics_move_it(self):
        """The last command wins."""
        self.corner.drive(0.2)
        self.corner.wait_for_speeds(0.2)
        self.corner.drive_base(-0.3)
        self.corner.wait_for_speeds(-0.3)

    def test_it_is_no_faster_than_a_turtlebot(self):
        """Ahead, back, left and right."""
        for asked, possible in [((5.0, 0.0), (TOP_SPEED, 0.0)), ((-1e9, 0.0), (-TOP_SPEED, 0.0)),
                                ((0.0, 20.0), (0.0, TOP_TURN)), ((0.0, -4.0), (0.0, -TOP_TURN))]:
            with self.subTest(asked=asked):
                self.corner.drive(*asked)
                self.corner.wait_for_speeds(*possible)

    def test_what_a_turtlebot_cannot_do_is_ignored(self):
        """It neither slides, flies nor rolls."""
        impossible = {'sideways': 0.5, 'up': 0.5, 'roll': 1.0, 'pitch': 1.0}
        self.corner.drive(0.2, 0.5, **impossible)
        self.corner.wait_for_speeds(0.2, 0.5)
        self.corner.drive(0.0, **impossible)
        self.corner.truth.wait_until_resting()

    def test_a_command_that_is_no_number_stops_it_and_is_warned_of(self):
        """In either velocity."""
        for command in (math.nan, 0.0), (0.0, math.inf):
            with self.subTest(command=command):
                self.corner.drive(0.3)
                self.corner.wait_for_speeds(0.3)
                self.corner.drive(*command)
                self.corner.truth.wait_until_resting()
        self.log.wait_for_warning('/corner/sim_turtlebot', 'is not finite')

    def test_it_stops_when_commands_cease(self):
        """After 0.6 s by its own clock, unless that is turned off."""
        self.corner.drive(0.3)
        self.alone.stop()
        self.alone.truth.clear()
        self.alone.drive(0.3)
        moving = self.alone.truth.wait_for(lambda m: speed(m) > 0.01).header.stamp
        resting = self.alone.truth.wait_for(
            lambda m: m.header.stamp > moving and speed(m) < REST_SPEED, what='rest').header.stamp
        # From the first message of a moving robot to that of one at rest: 0.6 s, 0.1 s to brake,
        # and a period in which the command may have come.
        self.assertTrue(0.55 < (resting - moving).to_sec() < 0.76, resting - moving)
        self.corner.truth.wait_seconds(2.0)
        self.corner.wait_for_speeds(0.3)

    def test_at_rest_it_is_at_rest(self):
        """Its place stays the same to the bit, after it has moved."""
        self.corner.drive(0.3, 1.0)
        self.corner.truth.wait_until_moving()
        self.corner.stop()
        self.corner.odometry.clear()
        self.corner.odometry.wait_for(lambda m: speed(m) == 0)
        self.corner.odometry.clear()
        poses = [message.pose for message in self.corner.odometry.wait_for_count(40)]
        self.assertEqual(poses, poses[:1] * 40)

    def test_a_reset_of_the_odometry_leaves_the_robot_where_it_is(self):
        """Odometry counts from zero; the truth does not change."""
        self.corner.drive(0.5, 1.0)
        self.corner.odometry.wait_for(lambda m: abs(heading(m)) > 45, what='a turn')
        self.corner.stop()
        truth = self.corner.truth.last.pose
        self.corner.odometry.clear()
        self.corner.reset_odometry()
        self.corner.odometry.wait_for(lambda m: place(m) == (0.0, 0.0, 0.0), what='zero')
        self.assertEqual(self.corner.truth.last.pose, truth)

    def test_the_services_pause_and_go_on(self):
        """Time stands still meanwhile."""
        self.corner.drive(0.1)
        self.corner.truth.wait_until_moving()
        self.corner.pause()
        paused = self.corner.truth.stamp
        self.corner.call('unpause_physics')
        self.corner.truth.wait_for(lambda m: m.header.stamp.to_sec() > paused)

    def test_the_services_reset_robot_and_time(self):
        """It stands at the start again."""
        self.corner.drive(0.5, 1.0)
        self.corner.truth.wait_until_moving()
        _, truth = self.corner.restart()
        self.assertEqual((place(truth), speed(truth)), (START, 0.0))
        self.corner.truth.wait_seconds(1.0)
        self.assertEqual(place(self.corner.truth.last), START)


if __name__ == '__main__':
    run_rostest('simulator', SimulatorTest, disable_rostime=True)
