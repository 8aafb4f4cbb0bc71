"""rotate.py over real topics: headings in, turns out; the test is the clock."""

import math

import pytest
import rospy
from geometry_msgs.msg import Twist, Vector3
from nav_msgs.msg import Odometry
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import rotator
from odometry_tests.waiting import wait_for_subscribers, wait_until
from std_msgs.msg import Float64

START = rotator
PERIOD = 0.1  # s, of the control


class Talk(Partner):
    """Headings to a turning node, commands from it."""

    def __init__(self, ns, clock):
        super().__init__(f'{ns}odom', Odometry, f'{ns}cmd_vel', Twist)
        self._target = rospy.Publisher(f'{ns}rotate_robot/target', Float64, queue_size=10)
        self.clock = clock
        self._time = self.clock.now.to_sec()

    def heading(self, degrees, after=PERIOD):
        """Return the next odometry message, measured `after` seconds after the last."""
        self._time += after
        return odometry(yaw=math.radians(degrees), stamp=self._time)

    def face(self, degrees, speed):
        """Look there until the node commands this turn (rad/s)."""
        self.say_until(lambda: self.heading(degrees), lambda m: turns_at(m, speed),
                       f'a turn at {speed} rad/s at a heading of {degrees} degrees')

    def look(self, degrees, speed):
        """Look there once; return once the node has commanded this turn (rad/s)."""
        self.say(self.heading(degrees))
        self.answers.wait_for(lambda m: turns_at(m, speed),
                              what=f'a turn at {speed} rad/s at a heading of {degrees} degrees')

    def aim(self, degrees):
        wait_for_subscribers(self._target)
        self._target.publish(Float64(degrees))

    def begin(self):
        """Return with a node that turns to 90 degrees; no command is on its way."""
        self.face(45.0, math.pi / 8)
        self.look(0.0, math.pi / 4)
        self.answers.clear()


def turns_at(command, speed):
    """Return whether a command is a turn on the spot at this speed (rad/s)."""
    on_the_spot = Twist(angular=Vector3(z=command.angular.z))
    return command == on_the_spot and abs(command.angular.z - speed) < 1e-9


@pytest.fixture
def talk(clock, ns):
    return Talk(ns, clock)


def test_the_turn_is_the_gain_times_the_error_by_the_shorter_way(talk):
    """Nothing before the first odometry; just 180 degrees off it turns to the left."""
    talk.clock.advance(*[PERIOD] * 30)
    assert talk.answers.messages == []
    for target, heading, error in [(90, 60, 30), (-180, 0, 180), (270, 0, -90), (-170, 170, 20)]:
        talk.aim(target)
        talk.face(heading, 0.5 * math.radians(error))


def test_commands_come_at_ten_hertz(talk):
    """From odometry at 20 Hz: one command for two messages."""
    talk.begin()
    headings = [talk.heading(0.1 * count, after=0.05) for count in range(200)]
    talk.say(*headings, talk.heading(90.0))
    talk.answers.wait_for(lambda m: turns_at(m, 0.0), what='the last command')
    expected = [0.5 * math.radians(90 - 0.1 * count) for count in range(1, 200, 2)] + [0.0]
    commands = [message.angular.z for message in talk.answers.messages]
    assert commands == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize('node', [
    ['_target:=-45', '_kp:=2', '_rate:=20', '_max_angular_speed:=0.3', '_timeout:=0']],
    indirect=True)
def test_parameters_change_how_it_turns(talk):
    """Target, gain, clamp and rate; without a timeout silence does not stop it."""
    talk.face(-45.0, 0.0)
    talk.face(0.0, -0.3)
    talk.face(170.0, 0.3)
    talk.look(-50.0, 2.0 * math.radians(5))
    talk.ask(*(talk.heading(-50.0, after=0.05) for _ in range(100)))
    talk.ask(odometry(yaw=math.radians(-50)))  # without a stamp, so that only the clock counts
    talk.answers.clear()
    for count in range(1, 9):
        talk.clock.advance(0.5)
        commands = talk.answers.wait_for_count(count)
    assert all(turns_at(m, 2.0 * math.radians(5)) for m in commands), commands


def test_strange_odometry_and_targets_are_ignored_with_a_warning(talk, node):
    """No message ends the node; each command is finite and within the clamp."""
    talk.begin()
    for target in math.nan, math.inf:
        talk.aim(target)
    node.wait_for_output('target ignored: nan degrees is not finite')
    talk.say(*strange_odometry())
    talk.face(60.0, math.pi / 12)
    node.wait_for_output('is no rotation')
    assert all(abs(message.angular.z) <= 3.14 for message in talk.answers.messages)


@pytest.mark.parametrize('node', [['_tolerance:=1']], indirect=True)
def test_within_the_tolerance_it_ends_once_the_robot_stands(talk, node):
    """With exit status 0 and a zero; not outside, and not while it still turns."""
    talk.face(88.9, 0.5 * math.radians(1.1))
    # Behind this answer no earlier one is still on its way.
    talk.look(88.8, 0.5 * math.radians(1.2))
    standing = [88.9 + 0.005 * count for count in range(10)]
    for degrees in standing + [89.1 + 0.15 * count for count in range(12)]:
        talk.look(degrees, 0.5 * math.radians(90 - degrees))

    def ended():
        talk.clock.advance(PERIOD)
        talk.say(talk.heading(90.5))
        return not node.running

    wait_until(ended, 10.0, lambda: f'its end; it printed:\n{node.output[-500:]}')
    assert node.wait() == 0, node.output
    wait_until(lambda: talk.answers.last == Twist(), 5.0, 'a zero at last')
    assert node.stdout.startswith('target=90.0 current:1.55')
