"""Faults that last; a robot whose minutes take a few seconds shares them with one in real time."""

import contextlib
import signal
from types import SimpleNamespace

import pytest
import rosgraph
from odometry_tests.pausing import call, pause
from odometry_tests.processes import Process
from odometry_tests.tutorial import LONGEST_STEP, Distance, Truth, detector, mover, simulator
from odometry_tests.waiting import wait_until

MINUTE = 60.0  # s of the robot's time
ODOM_RATE = 100  # Hz; a minute of it is more than a socket holds
QUEUE_SIZE = 10  # messages, of the simulator's publishers
GOAL = 0.3  # m
DEAF, PAUSED = {'ROS_NAMESPACE': 'deaf'}, {'ROS_NAMESPACE': 'paused'}


@pytest.fixture(scope='module')
def minute(master):
    """Let a minute pass; return what was seen of both robots."""
    with robot_paused_on_its_way() as paused, robot_with_deaf_listener() as deaf:
        deaf.truth.wait_seconds(MINUTE, timeout=MINUTE)
    return SimpleNamespace(deaf=deaf, paused=paused)


def use_sim_time(value):
    """Have the nodes that start from now on use the simulator's time, or the wall's."""
    rosgraph.Master('/test').setParam('/use_sim_time', value)


@contextlib.contextmanager
def robot_with_deaf_listener():
    """Run a robot with a listener to odom that is stopped for the whole context."""
    truth = Truth('/deaf/')
    use_sim_time(True)
    with simulator(f'_odom_rate:={ODOM_RATE}', '_real_time_factor:=10', env=DEAF), \
            Process('rostopic', 'echo', '-p', '/deaf/odom/header/seq') as listener:
        wait_until(lambda: heard(listener), 20.0, 'a message')
        listener.send(signal.SIGSTOP)
        try:
            seen = SimpleNamespace(truth=truth)
            yield seen
            pause(truth, namespace='/deaf/')
            seen.sent = truth.last.header.seq
        finally:
            listener.send(signal.SIGCONT)
        wait_until(lambda: seen.sent in heard(listener), 20.0, 'a listener that has woken up')
        seen.heard = heard(listener)


def heard(listener):
    """Return the numbers of the messages that a listener has printed."""
    lines = listener.stdout.splitlines()
    return [int(line.split(',')[1]) for line in lines if line[:1].isdigit()]


@contextlib.contextmanager
def robot_paused_on_its_way():
    """Run a robot that drives, is paused for the whole context, and then arrives."""
    truth, moved = Truth('/paused/'), Distance('/paused/')
    use_sim_time(False)
    with simulator(env=PAUSED), detector(env=PAUSED), \
            mover(f'_distance:={GOAL}', env=PAUSED) as driver:
        moved.wait_for(lambda m: m.data > 0.05, what='5 cm')
        pause(truth, moved, namespace='/paused/')
        before = truth.last
        seen = SimpleNamespace(moved=moved, truth=truth)
        yield seen
        driver.wait_for_output('no moved_distance arrives')
        assert truth.last is before, 'the robot moved while it was paused'
        call('unpause_physics', '/paused/')
        seen.arrived = moved.wait_until_arrived(GOAL)


def test_a_listener_stopped_for_a_minute_stops_nobody_else(minute):
    """The simulator goes on, and holds no more messages for one that sleeps than its queue."""
    numbers = minute.deaf.heard
    held = next((count for count in range(1, len(numbers))
                 if numbers[-count] > numbers[-count - 1] + 1), len(numbers))
    assert held <= QUEUE_SIZE


def test_a_pause_loses_nothing(minute):
    """Paused in mid-drive, the robot stands; afterwards it drives on to its goal."""
    assert minute.paused.arrived == pytest.approx(x(minute.paused.truth.last), abs=1e-3)
    seen = minute.paused.truth.messages
    steps = [(x(after) - x(before)) / (after.header.seq - before.header.seq)
             for before, after in zip(seen, seen[1:])]
    assert max(steps) < LONGEST_STEP, 'the pause shows in the distance'


def x(message):
    """Return how far ahead (m) a robot is."""
    return message.pose.pose.position.x
