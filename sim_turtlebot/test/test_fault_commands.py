"""Commands that no healthy controller sends, and more of them than anybody expects."""

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

pytestmark = pytest.mark.usefixtures('simulated_time')


@pytest.fixture
def talk(master):
    return Partner('cmd_vel', Twist, 'base_pose_ground_truth', Odometry)


def strange_twists():
    """Return a Twist with each strange number in each of its places."""
    twists = []
    for value, part, axis in itertools.product(STRANGE, ('linear', 'angular'), 'xyz'):
        twist = Twist()
        setattr(getattr(twist, part), axis, value)
        twists.append(twist)
    return twists


def velocity(message):
    """Return the speeds (m/s, rad/s) ahead and to the left in an Odometry."""
    return message.twist.twist.linear.x, message.twist.twist.angular.z


def obeyed(command):
    """Return the speeds (m/s, rad/s) at which a TurtleBot 2 obeys a Twist."""
    linear, angular = command.linear.x, command.angular.z
    if not (math.isfinite(linear) and math.isfinite(angular)):
        return 0.0, 0.0
    return (max(-TOP_SPEED, min(TOP_SPEED, linear)), max(-TOP_TURN, min(TOP_TURN, angular)))


def drive(talk, command, expected):
    """Command once, and return when the robot moves steadily at the speeds expected.

    It has no watchdog here: however late a message is, the robot does what it was told last.
    """
    talk.say(command)

    def steady():
        recent = talk.answers.messages[-STEADY:]
        return all(velocity(m) == pytest.approx(expected, abs=0.02) for m in recent)

    wait_until(steady, 10.0, lambda: f'{expected} m/s and rad/s after\n{command}\n'
               f'but {velocity(talk.answers.last)}')


def test_strange_commands_leave_the_robot_finite_and_within_its_limits(talk):
    with simulator('_real_time_factor:=20', '_cmd_vel_timeout:=0') as node:
        talk.wait_for_listener()
        talk.answers.wait_for_count(STEADY)
        for command in strange_twists():
            drive(talk, twist(0.3, 1.0), (0.3, 1.0))
            drive(talk, command, obeyed(command))
        node.wait_for_output('is not finite')
        assert node.running
    for message in talk.answers.messages:
        position = message.pose.pose.position
        assert all(map(math.isfinite, (position.x, position.y, position.z)))
        linear, angular = velocity(message)
        assert abs(linear) < 1.05 * TOP_SPEED and abs(angular) < 1.05 * TOP_TURN
