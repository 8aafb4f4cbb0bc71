"""rotate.py over real topics, where the test is the clock, and its arithmetic for any numbers."""

import math

import pytest
import rospy
from geometry_msgs.msg import Twist, Vector3
from heading_control.turn import Turn
from hypothesis import example, given
from hypothesis import strategies as st
from nav_msgs.msg import Odometry
from odometry_tests.fuzzing import any_number
from odometry_tests.messages import odometry, strange_odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import rotator
from odometry_tests.waiting import TIMEOUT, wait_for_subscribers, wait_until
from std_msgs.msg import Float64

START = rotator
PERIOD = 0.1  # s, of the control
finite = any_number.filter(math.isfinite)
positive = finite.filter(lambda value: value > 0)


class Talk(Partner):
    """Headings to a turning node, commands from it; time passes when the test says so."""

    def __init__(self, ns, clock):
        super().__init__(f'{ns}odom', Odometry, f'{ns}cmd_vel', Twist)
        self._target = rospy.Publisher(f'{ns}rotate_robot/target', Float64, queue_size=10)
        self.clock = clock

    def look(self, degrees):
        self.say(odometry(yaw=math.radians(degrees), stamp=self.clock.now.to_sec()))

    def tick(self, period=PERIOD):
        count = len(self.answers.messages)
        self.clock.advance(period)
        return self.answers.wait_for_count(count + 1)[count]

    def face(self, degrees, speed, period=PERIOD):
        def commanded():
            self.look(degrees)
            return turns_at(self.tick(period), speed)

        wait_until(commanded, TIMEOUT, lambda: f'a turn at {speed} rad/s at a heading of {degrees} '
                   f'degrees; the last was:\n{self.answers.last}')

    def aim(self, degrees):
        wait_for_subscribers(self._target)
        self._target.publish(Float64(degrees))

    def begin(self, degrees=0.0, ticks_before=()):
        wait_for_subscribers(self._publisher)
        self.answers.wait_for_publisher()
        self.clock.advance(*ticks_before)
        self.look(degrees)
        self.answers.wait_for_count(1)


def turns_at(command, speed):
    """Return whether a command is a turn on the spot at this speed (rad/s)."""
    on_the_spot = Twist(angular=Vector3(z=command.angular.z))
    return command == on_the_spot and abs(command.angular.z - speed) < 1e-9


@pytest.fixture
def talk(clock, ns):
    return Talk(ns, clock)


def test_commands_come_at_ten_hertz_from_the_first_odometry_on(talk):
    talk.begin(10.0, ticks_before=[1.0] * 3)
    talk.face(30.0, 0.5 * math.radians(60))
    early = [m for m in talk.answers.messages
             if not any(turns_at(m, 0.5 * math.radians(error)) for error in (80, 60))]
    assert not early, f'these came before the first odometry: {early}'
    talk.answers.clear()
    for count in range(1, 51):
        for _ in range(2):
            talk.look(30.0)
            talk.clock.advance(PERIOD / 2)
        talk.answers.wait_for_count(count)
    talk.face(90.0, 0.0)
    count = sum(not turns_at(m, 0.0) for m in talk.answers.messages)
    assert 50 <= count <= 60, 'twice as many would be a command for each odometry'


def test_silence_stops_it_also_when_time_goes_back(talk, node):
    """As of a relay that ends while the simulator is reset; odometry that returns turns it again."""
    talk.begin()
    talk.face(0.0, math.pi / 4)
    count = len(talk.answers.messages)
    talk.clock.advance(-20.0)
    # Not with tick(): the node may see the first one together with the jump, and only begin its period there.
    wait_until(lambda: talk.clock.advance(PERIOD) or turns_at(talk.answers.last, 0.0), TIMEOUT, 'a stop')
    turning = [command for command in talk.answers.messages[count:] if not turns_at(command, 0.0)]
    assert len(turning) <= 20, 'at 10 Hz: it waited for the time before the reset'
    node.wait_for_output('stopping: no odometry arrives')
    talk.face(0.0, math.pi / 4)


@pytest.mark.parametrize('node', [
    ['_target:=-45', '_kp:=2', '_rate:=20', '_max_angular_speed:=0.3']], indirect=True)
def test_parameters_change_how_it_turns(talk):
    """Target, gain, clamp and rate."""
    talk.begin()
    talk.face(0.0, -0.3, 0.05)
    talk.face(-50.0, 2.0 * math.radians(5), 0.05)


def test_strange_odometry_and_targets_are_ignored_with_a_warning(talk, node):
    """No message ends the node; each command is finite and within the clamp."""
    talk.begin()
    talk.aim(math.nan)
    node.wait_for_output('target ignored: nan degrees is not finite')
    talk.say(*strange_odometry())
    talk.face(60.0, math.pi / 12)
    node.wait_for_output('is no rotation')
    assert all(abs(message.angular.z) <= 3.14 for message in talk.answers.messages)


@pytest.mark.parametrize('node', [['_tolerance:=1', '_rate:=50']], indirect=True)
def test_within_the_tolerance_it_ends_once_the_robot_stands(talk, node):
    """With exit status 0 and a zero; not outside."""
    talk.begin()
    for _ in range(40):
        talk.face(88.9, 0.5 * math.radians(1.1), 0.02)

    def ended():
        talk.look(90.5)
        talk.clock.advance(0.02)
        return not node.running

    wait_until(ended, 10.0, lambda: f'its end; it printed:\n{node.output[-500:]}')
    assert node.wait() == 0, node.output
    wait_until(lambda: talk.answers.last == Twist(), 5.0, 'a zero at last')
    assert 'target=90.0 current:1.55' in node.stdout


@given(st.floats(-math.pi, math.pi), finite, positive, positive)
@example(0.0, -180.0, 0.5, 3.0)  # half a circle is to the left
@example(0.0, 60.0, 0.5, 3.0)
@example(0.0, 270.0, 0.5, 0.1)
def test_the_turn_is_the_gain_times_the_shorter_way_within_the_clamp(yaw, target, kp, limit):
    """For any target (degrees)."""
    turn = Turn(target, kp, limit)
    error = turn.error_at(yaw)
    assert -math.pi < error <= math.pi
    if abs(target) < 1e6:  # beyond, the target itself is less exact than the way to it
        off = math.remainder(yaw + error - math.radians(target), math.tau)
        assert off == pytest.approx(0.0, abs=1e-9)
    assert turn.speed_for(error) == max(-limit, min(limit, kp * error))
