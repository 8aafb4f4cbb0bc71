"""The mover over real topics: moved distance in, velocity commands out; its time stands still unless a test is its clock."""

import math
import signal

import pytest
import rosgraph
from geometry_msgs.msg import Twist, Vector3
from odometry_tests.messages import STRANGE
from odometry_tests.partners import Partner
from odometry_tests.tutorial import detector, mover
from odometry_tests.waiting import TIMEOUT, wait_until
from std_msgs.msg import Float64

START = mover
FIRST = -1.0  # m
FAR = 1e6  # m, beyond every goal
JUST_BEFORE_TWO = 2.0 - 2.0**-52  # m


def commands(*speeds):
    """Return Twists that are zero but for their speed ahead (m/s)."""
    return [Twist(linear=Vector3(x=speed)) for speed in speeds]


@pytest.fixture
def partner(node, ns):
    """Return a Partner that tells distances to a mover, and records its commands."""
    return Partner(f'{ns}moved_distance', Float64, f'{ns}cmd_vel', Twist)


@pytest.fixture
def tell(partner):
    """Return a function that tells distances to a mover that has begun, and returns its commands."""
    partner.say_until(lambda: Float64(FIRST), lambda m: m.linear.x != 0, 'a start')
    partner.say(Float64(FAR))
    partner.answers.wait_for(lambda m: m.linear.x == 0, what='a stop')
    return lambda *distances: partner.ask(*map(Float64, distances))


def test_the_latest_distance_decides_on_one_command(partner, tell, clock):
    """To the bit; after a reset of the distance it drives on: it does not remember that it has arrived."""
    assert tell(JUST_BEFORE_TWO, 2.0, 2.1, 0.0, 2.0) == commands(0.1, 0.0, 0.0, 0.1, 0.0)
    assert len(partner.answers.messages) == 5
    for _ in range(8):  # it goes on commanding zero, however long the robot rests
        clock.advance(0.4)
        assert tell(2.0) == commands(0.0)


def test_a_distance_that_is_not_finite_stops_it_with_a_warning(tell, node):
    assert tell(*STRANGE) == commands(0.0, 0.0, 0.0, 0.0, 0.1, 0.1, 0.1)
    assert tell(math.inf, 1.0) == commands(0.0, 0.1)
    node.wait_for_output('the moved distance nan is not finite')


@pytest.mark.parametrize('node, told, speeds', [
    (['_distance:=0.5', '_speed:=-0.2'], [0.0, 0.499, 0.5, 3.0], [-0.2, -0.2, 0.0, 0.0]),
    (['_relative:=true'], [FIRST + 1.999, FIRST + 2.0, 0.0], [0.1, 0.0, 0.1])], indirect=['node'])
def test_it_drives_backwards_as_far_as_it_is_told_or_from_the_first_distance_on(tell, told, speeds):
    assert tell(*told) == commands(*speeds)


@pytest.mark.parametrize('node', [['_exit_when_done:=true']], indirect=True)
def test_exit_when_done_ends_it_once_the_robot_stands(partner, tell, clock, node):
    assert tell(2.0, 2.01, 2.02, 2.03) == commands(0.0, 0.0, 0.0, 0.0)
    assert node.running

    def ended():
        clock.advance(0.1)
        partner.say(Float64(2.03))
        return not node.running

    wait_until(ended, 10.0, lambda: f'its end; it printed:\n{node.output}')
    assert node.wait() == 0, node.output
    wait_until(lambda: partner.answers.last == Twist(), 5.0, 'a zero at last')


def test_of_two_publishers_of_the_distance_one_that_was_killed_is_none(node, ns):
    """It stays registered. If another one was left running, the robot drives off whenever the other stops it.

    A mover warns once, by name: of the two others, so not before of one of them and the first.
    """
    topic, master = f'{ns}moved_distance', rosgraph.Master('/test')
    with detector('__name:=killed') as killed:
        wait_until(lambda: topic in dict(master.getSystemState()[0]), TIMEOUT, 'a detector')
        killed.end(signal.SIGKILL)
    with detector('__name:=one'), detector('__name:=two'):
        node.wait_for_output(f'{topic} is published by {ns}one and {ns}two: ')
    assert node.output.count('is published by') == 1, node.output


def test_a_mover_that_has_nothing_to_drive_says_so_once(partner, node):
    """As in a second run, while the detector still says two metres."""
    partner.say_until(lambda: Float64(2.005), lambda m: m == Twist(), 'a zero')
    node.wait_for_output('moved_distance is 2.005 m already: nothing to drive. Reset it')
    partner.say(Float64(0.0), Float64(2.005))
    partner.answers.wait_for(lambda m: m != Twist(), what='a start')
    assert node.output.count('nothing to drive') == 1


def test_it_says_that_it_waits_for_a_detector(node):
    node.wait_for_output('waiting for moved_distance on ')
