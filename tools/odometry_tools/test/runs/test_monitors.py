"""What the demo shows during a run and how it judges it, from scripted messages and clocks."""

import math
import re

import pytest
from odometry_tests.messages import odometry
from odometry_tools.runs.monitors import MoveMonitor, RotateMonitor
from odometry_tools.runs.options import parse
from std_msgs.msg import Float64


@pytest.fixture
def play(monkeypatch):
    """Return a function that plays messages of topics to a monitor, alternately.

    The last of the topics may be `late` by some messages, or early.
    """
    def played(kind, arguments, topics, late=0):
        callbacks = {}
        monkeypatch.setattr('odometry_tools.runs.monitors.rospy.Subscriber',
                            lambda topic, kind, callback, **_: callbacks.update({topic: callback}))
        monitor = kind(parse(arguments))
        last = [*topics][-1]
        messages = [(number + late * (topic == last), topic, message)
                    for topic, messages in topics.items()
                    for number, message in enumerate(messages)]
        for _, topic, message in sorted(messages, key=lambda message: message[0]):
            callbacks[topic](message)
        return monitor

    return played


@pytest.fixture
def run(play):
    def played(moved, true=None, **options):
        truth = [odometry(x=x, stamp=0.05 * step) for step, x in enumerate(true or moved)]
        for message, distance, before in zip(truth, moved, [0.0, *moved]):
            message.twist.twist.linear.x = (distance - before) / 0.05
        return play(MoveMonitor, [], {'moved_distance': map(Float64, moved),
                                      'base_pose_ground_truth': truth}, **options)

    return played


DRIVE = [0.005 * step for step in range(400)]
AT_ONCE = [2.0, 2.002, 2.002]
ORDERS = [-30, -1, 0, 1, 30]


@pytest.mark.parametrize('error', [-0.01, 0.01])
def test_a_robot_that_is_not_where_its_odometry_says_is_an_error(run, error):
    moved = [*DRIVE, *AT_ONCE]
    monitor = run(moved, [distance + error for distance in moved])
    assert monitor.result()[1] == 'the two distances do not agree'


@pytest.mark.parametrize('moved, true', [
    (DRIVE, None), ([*DRIVE, 2.0], None), ([*DRIVE[:300], *[DRIVE[300]] * 50], None),
    ([*DRIVE, 2.0, 2.001, 2.002], [*DRIVE, 2.002, 2.002, 2.002])])
def test_a_robot_that_moves_or_stands_too_early_has_not_arrived(run, moved, true):
    """Nor one that stands while the sum still grows: its last value is what is shown."""
    assert run(moved, true).end is None


@pytest.mark.parametrize('late', ORDERS)
def test_a_drive_is_shown_as_it_was_on_arrival(run, late):
    pushed = [2.002 + 0.01 * step for step in range(40)]
    monitor = run([*DRIVE, *AT_ONCE, *[2.002] * 40, *pushed], late=late)
    summary, complaint = monitor.result()
    assert re.search(r'moved distance +2\.002 m', summary) and complaint is None
    assert monitor.progress().endswith(' 2.00 of 2.00 m, 0.00 m/s, 20.1 s')


@pytest.mark.parametrize('late', ORDERS)
def test_a_turn_is_shown_as_it_was_on_arrival(play, late):
    """The robot creeps on towards its target: each odometry goes with the truth of its moment."""
    yaws = [math.pi / 2 * (1 - math.exp(-0.5 * 0.05 * step)) for step in range(400)]
    topics = {topic: [odometry(yaw=yaw, stamp=0.05 * step) for step, yaw in enumerate(yaws)]
              for topic in ('odom', 'base_pose_ground_truth')}
    monitor = play(RotateMonitor, ['rotate'], topics, late)
    assert re.search(r'heading +89\.90 .*\ntrue turn +89\.90 ', monitor.result()[0])
    assert monitor.progress().endswith(' 89.9 degrees, 0.1 to go, 13.7 s')
