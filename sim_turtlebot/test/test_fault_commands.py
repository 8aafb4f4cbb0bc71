"""Commands that no healthy controller sends."""

import itertools
import math

import pytest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import STRANGE
from odometry_tests.partners import Partner
from odometry_tests.robots import twist
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import wait_until

TOP_SPEED, TOP_TURN = 0.7, math.pi  # m/s, rad/s, of a TurtleBot 2
STEADY = 5  # messages in a row at the same speed


def obeyed(command):
    """Return the speeds (m/s, rad/s) at which a TurtleBot 2 obeys a Twist."""
    linear, angular = command.linear.x, command.angular.z
    if not (math.isfinite(linear) and math.isfinite(angular)):
        return 0.0, 0.0
    return (max(-TOP_SPEED, min(TOP_SPEED, linear)), max(-TOP_TURN, min(TOP_TURN, angular)))


def drive(talk, command, expected):
    """Command once, and return when the robot moves steadily at the speeds expected.

    It has no watchdog here: however late a message is, the robot obeys the last command.
    """
    talk.say(command)

    def speeds():
        twists = [message.twist.twist for message in talk.answers.messages[-STEADY:]]
        return [(twist.linear.x, twist.angular.z) for twist in twists]

    wait_until(lambda: all(seen == pytest.approx(expected, abs=0.02) for seen in speeds()), 10.0,
               lambda: f'{expected} m/s and rad/s after\n{command}\nbut {speeds()[-1]}')


def test_strange_commands_leave_the_robot_within_its_limits(simulated_time):
    """A Twist with each strange number in each of its places."""
    talk = Partner('cmd_vel', Twist, 'base_pose_ground_truth', Odometry)
    with simulator('_real_time_factor:=20', '_cmd_vel_timeout:=0') as node:
        talk.wait_for_listener()
        talk.answers.wait_for_count(STEADY)
        for value, part, axis in itertools.product(STRANGE, ('linear', 'angular'), 'xyz'):
            command = Twist()
            setattr(getattr(command, part), axis, value)
            drive(talk, twist(0.3, 1.0), (0.3, 1.0))
            drive(talk, command, obeyed(command))
        node.wait_for_output('is not finite')
