"""Odometry and distances that no healthy driver sends, and more than anybody expects."""

import itertools
import math

import pytest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import STRANGE, odometry
from odometry_tests.partners import Partner
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import detector, mover, rotator
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

QUATERNIONS = [(0, 0, 0, 0), (0, 0, 0, 1e-320), (0, 0, 3, 4), (1e200, 0, 0, 1e200),
               *((value, 0, 0, 1) for value in STRANGE)]
STAMPS = [0.0, 5.0, 5.0, 4.0, 3605.0, 5.0]
CASES = itertools.count(1)


@pytest.fixture
def ns(master, monkeypatch):
    """Give each test's nodes a namespace of their own: no connection is left from another one."""
    name = f'case_{next(CASES)}'
    monkeypatch.setenv('ROS_NAMESPACE', name)
    return f'/{name}/'


def strange_odometry():
    """Return an Odometry with each strange number in each place, and strange stamps and frames."""
    messages = [odometry(stamp=stamp) for stamp in STAMPS]
    messages += [odometry(x=value) for value in STRANGE] + [odometry(y=value) for value in STRANGE]
    for numbers in QUATERNIONS:
        message = odometry()
        turn = message.pose.pose.orientation
        turn.x, turn.y, turn.z, turn.w = numbers
        messages.append(message)
    messages.append(Odometry())  # empty frames, no length of the quaternion, no stamp
    return messages


def odometry_for(ns, topic, kind):
    """Return what sends odometry to a node and hears its answers on a topic."""
    return Partner(f'{ns}odom', Odometry, f'{ns}{topic}', kind)


def meet_detector(ns):
    """Return what talks to a detector that has counted one centimetre, at x = 0.01 m and 1 s."""
    talk = odometry_for(ns, 'moved_distance', Float64)
    talk.say_until(odometry, lambda m: m.data == 0.0, 'a distance')
    talk.say(odometry(x=0.01, stamp=1.0))
    talk.answers.wait_for(lambda m: m.data == 0.01, what='a centimetre')
    return talk


def test_the_detector_counts_on_through_strange_odometry(ns):
    """No message ends it, and the sum stays finite and never falls."""
    talk = odometry_for(ns, 'moved_distance', Float64)
    with detector() as node:
        talk.say_until(odometry, lambda m: m.data == 0.0, 'a distance')
        talk.say(*strange_odometry())
        talk.say(*(odometry(x=0.01 * step, stamp=10000 + 0.05 * step) for step in range(20)))
        talk.answers.wait_for(lambda m: m.data > 0.189, what='the healthy messages\' distance')
        assert node.end() == 0, node.output
    distances = [message.data for message in talk.answers.messages]
    assert all(math.isfinite(distance) for distance in distances)
    assert distances == sorted(distances)
    assert distances[-1] < 0.191


def test_strange_odometry_does_not_end_main(ns):
    """It prints on."""
    talk = odometry_for(ns, 'nothing', Float64)
    with rosrun('rotate_robot', 'main.py') as node:
        talk.wait_for_listener()
        talk.say(*strange_odometry(), odometry(yaw=0.26000001, stamp=20000))
        node.wait_for_output('0.26')
        assert node.end() == 0, node.output


def test_strange_odometry_does_not_end_rotate(ns):
    """And no command is other than finite and within the clamp."""
    talk = odometry_for(ns, 'cmd_vel', Twist)
    with rotator('_timeout:=0') as node:
        talk.say_until(odometry, lambda m: m.angular.z > 0, 'a turn')
        talk.say(*strange_odometry(), odometry(yaw=0.26000001, stamp=20000))
        talk.answers.wait_for(lambda m: m.angular.z == pytest.approx(
            0.5 * (math.pi / 2 - 0.26000001)), what='the turn from the last heading')
        assert node.end() == 0, node.output
    assert all(abs(message.angular.z) <= 3.14 for message in talk.answers.messages)


@pytest.mark.parametrize('step, start, period, count', [
    (0.001, 2, 1, 3000), (0.001, 1.001, 0.001, 3000), (0.005, 11, 0.05, 200)],
    ids=['slow', 'fast', 'in a burst'])
def test_no_distance_is_lost_at_slow_and_at_fast_odometry(ns, step, start, period, count):
    """Once or a thousand times a second; and ten seconds of it, held up on the way, at once."""
    path = [0.01 + step * number for number in range(1, count + 1)]
    with detector() as node:
        talk = meet_detector(ns)
        distances = talk.ask(*(odometry(x=x, stamp=start + period * number)
                               for number, x in enumerate(path)))
        assert node.end() == 0, node.output
    assert [m.data for m in distances] == pytest.approx(path, abs=1e-9)
    assert 'not counted' not in node.output


def test_two_publishers_at_once_are_jumps_and_not_metres(ns):
    """Two robots on one topic, a hundred metres apart: nothing moves, nothing is counted."""
    with detector() as node:
        talk = meet_detector(ns)
        distances = talk.ask(*(odometry(x=0.01 + 100.0 * (step % 2), stamp=1 + 0.01 * step)
                               for step in range(100)))
        node.wait_for_output('not counted')
    assert {m.data for m in distances} == {0.01}


def test_a_kidnapped_robot_goes_on_to_two_metres(ns):
    """A teleport in the middle of the drive is no movement, and the mover goes on."""
    commands = Recorder(f'{ns}cmd_vel', Twist)
    with detector() as node, mover('_timeout:=0'):
        talk = meet_detector(ns)
        talk.say_until(lambda: odometry(x=0.01, stamp=1.0), lambda _: commands.last, 'a command')
        talk.say(odometry(x=0.02, stamp=1.05))
        talk.answers.wait_for(lambda m: m.data == 0.02, what='another centimetre')
        distances = [m.data for m in talk.ask(*(
            odometry(x=0.02 * step + (50.0 if step > 60 else 0.0), stamp=1 + 0.05 * step)
            for step in range(2, 120)))]
        expected = [0.1 if distance < 2.0 else 0.0 for distance in distances]
        wait_until(lambda: [m.linear.x for m in commands.messages][-len(expected):] == expected,
                   10.0, lambda: f'{expected} but {commands.messages}')
        node.wait_for_output('not counted')
    assert distances[-1] == pytest.approx(0.02 * 118)
