"""The mover over real topics: moved distance in, velocity commands out; the test is the clock."""

import math
import signal

import pytest
import rosgraph
from geometry_msgs.msg import Twist, Vector3
from nav_msgs.msg import Odometry
from odometry_tests.messages import STRANGE, odometry
from odometry_tests.partners import Partner
from odometry_tests.tutorial import detector, mover
from odometry_tests.waiting import TIMEOUT, Recorder, wait_until
from rosgraph_msgs.msg import Log
from std_msgs.msg import Float64

START = mover
FAR = 1e6  # m, beyond every goal
JUST_BEFORE_TWO = 2.0 - 2.0**-52  # m


def commands(*speeds):
    """Return Twists that are zero but for their speed ahead (m/s)."""
    return [Twist(linear=Vector3(x=speed)) for speed in speeds]


class Talk(Partner):
    """Distances to a mover, commands from it."""

    def __init__(self, ns, clock):
        super().__init__(f'{ns}moved_distance', Float64, f'{ns}cmd_vel', Twist)
        self.clock, self._ns, self._log = clock, ns, Recorder('/rosout', Log)

    def begin(self, start=0.0, goal=FAR):
        def begun():
            self.say_until(lambda: Float64(start), lambda m: m.linear.x != 0, 'a start')
            self.say(Float64(goal))
            self.answers.wait_for(lambda m: m.linear.x == 0, what='a stop')
            # It logs by its own time that it starts.
            return any(m.name == f'{self._ns}test_movement' and m.header.stamp >= self.clock.now
                       for m in self._log.messages)

        wait_until(begun, 10.0, 'a mover that knows the time')
        self.tell(start)
        self.answers.clear()
        return self

    def tell(self, *distances):
        return self.ask(*map(Float64, distances))

    def be_silent_until_it_stops(self):
        def stopped():
            self.clock.advance(0.1)
            return Twist() in self.answers.messages
        wait_until(stopped, 10.0, 'a stop')


@pytest.fixture
def talk(clock, ns):
    return Talk(ns, clock)


def test_the_latest_distance_decides_on_one_command(talk):
    """To the bit; after a reset of the distance it drives on: it does not remember that it has arrived."""
    talk.begin()
    assert talk.tell(JUST_BEFORE_TWO, 2.0, 2.1, 0.0) == commands(0.1, 0.0, 0.0, 0.1)
    assert len(talk.answers.messages) == 4
    for _ in range(8):  # it goes on commanding zero, however long the robot rests
        talk.clock.advance(0.4)
        assert talk.tell(2.0) == commands(0.0)


def test_a_distance_that_is_not_finite_stops_it_with_a_warning(talk, node):
    talk.begin()
    assert talk.tell(*STRANGE) == commands(0.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.1)
    assert talk.tell(math.inf, 1.0) == commands(0.0, 0.1)
    node.wait_for_output('the moved distance nan is not finite')


@pytest.mark.parametrize('node', [['_distance:=0.5', '_speed:=-0.2', '_timeout:=0']], indirect=True)
def test_it_drives_backwards_as_far_as_it_is_told_and_silence_need_not_stop_it(talk, ns):
    """A mover with a timeout, beside it in the same time, stops meanwhile."""
    assert talk.begin().tell(0.0, 0.499, 0.5, 3.0) == commands(-0.2, -0.2, 0.0, 0.0)
    talk.tell(0.1)
    with mover(env={'ROS_NAMESPACE': f'{ns}beside'}):
        Talk(f'{ns}beside/', talk.clock).begin().be_silent_until_it_stops()
    talk.say(Float64(0.1))
    assert talk.answers.wait_for_count(2) == commands(-0.2, -0.2)


@pytest.mark.parametrize('node', [['_relative:=true']], indirect=True)
def test_relative_counts_from_the_first_distance(talk):
    assert talk.begin(start=10.0).tell(11.999, 12.0, 0.0) == commands(0.1, 0.0, 0.1)


@pytest.mark.parametrize('node', [['_exit_when_done:=true']], indirect=True)
def test_exit_when_done_ends_it_once_the_robot_stands(talk, node):
    talk.begin(goal=2.0)
    for distance in (2.0, 2.01, 2.02, 2.03):
        talk.clock.advance(0.4)
        assert talk.tell(distance) == commands(0.0)
    assert node.running

    def ended():
        talk.clock.advance(0.1)
        talk.say(Float64(2.03))
        return not node.running

    wait_until(ended, 10.0, lambda: f'its end; it printed:\n{node.output}')
    assert node.wait() == 0, node.output
    wait_until(lambda: talk.answers.last == Twist(), 5.0, 'a zero at last')


def test_two_publishers_of_the_distance_are_warned_of_once_by_name(talk, node, ns):
    """If a detector was left running, the robot drives off whenever the other one stops it."""
    talk.begin()
    with detector(env={'ROS_NAMESPACE': ns.strip('/')}):
        Partner(f'{ns}odom', Odometry, f'{ns}moved_distance', Float64).say_until(
            odometry, lambda _: True, 'a distance')
        node.wait_for_output(f'{ns}moved_distance is published by ')
    line, = [line for line in node.output.splitlines() if 'is published by' in line]
    assert '/system_test' in line and f'{ns}movement_detector_node_' in line


def test_a_detector_that_was_killed_is_no_second_publisher(node, ns):
    """It stays registered. A mover warns once: of the two others, so not before of one of them and the first."""
    topic, master = f'{ns}moved_distance', rosgraph.Master('/test')
    with detector('__name:=killed') as killed:
        wait_until(lambda: topic in dict(master.getSystemState()[0]), TIMEOUT, 'a detector')
        killed.end(signal.SIGKILL)
    with detector('__name:=one'), detector('__name:=two'):
        node.wait_for_output(f'{topic} is published by {ns}one and {ns}two: ')


def test_a_mover_that_has_nothing_to_drive_says_so_once(talk, node):
    """As in a second run, while the detector still says two metres."""
    talk.say_until(lambda: Float64(2.005), lambda m: m == Twist(), 'a zero')
    node.wait_for_output('moved_distance is 2.005 m already: nothing to drive. Reset it')
    talk.tell(2.005, 0.0, 2.005)
    assert node.output.count('nothing to drive') == 1


def test_it_says_that_it_waits_for_a_detector(node):
    node.wait_for_output('waiting for moved_distance on ')
