"""Faults that last a minute; two of them share it."""

import contextlib
import signal
from types import SimpleNamespace

import pytest
import rospy
from odometry_tests.processes import rosrun
from odometry_tests.tutorial import Truth, detector, mover, simulator
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64
from std_srvs.srv import Empty

MINUTE = 60.0  # s
ODOM_RATE = 100  # Hz; a minute of it is more than a socket holds
GOAL = 0.5  # m
DEAF, PAUSED = {'ROS_NAMESPACE': 'deaf'}, {'ROS_NAMESPACE': 'paused'}


@pytest.fixture(scope='module')
def minute(master):
    """Let a minute pass; return what was seen of both robots."""
    with robot_with_deaf_listener() as deaf, robot_paused_on_its_way() as paused:
        deaf.truth.wait_seconds(MINUTE, timeout=MINUTE + 10.0)
    return SimpleNamespace(deaf=deaf, paused=paused)


@contextlib.contextmanager
def robot_with_deaf_listener():
    """Run a robot with a listener to odom that is stopped for the whole context."""
    truth = Truth('/deaf/')
    with simulator(f'_odom_rate:={ODOM_RATE}', env=DEAF) as robot, \
            rosrun('rotate_robot', 'main.py', env=DEAF) as listener:
        listener.wait_for_output('0.0')
        listener.send(signal.SIGSTOP)
        try:
            truth.wait_seconds(1.0)
            memory, heard = resident_memory(robot), len(truth.messages)
            seen = SimpleNamespace(truth=truth)
            yield seen
            seen.grown = resident_memory(robot) - memory
            seen.messages = truth.messages[heard:]
        finally:
            listener.send(signal.SIGCONT)


@contextlib.contextmanager
def robot_paused_on_its_way():
    """Run a robot that drives, is paused for the whole context, and then arrives."""
    truth, moved = Truth('/paused/'), Recorder('/paused/moved_distance', Float64)
    with simulator(env=PAUSED), detector(env=PAUSED), \
            mover(f'_distance:={GOAL}', env=PAUSED) as driver:
        moved.wait_for(lambda m: m.data > 0.1, 20.0, '0.1 m')
        call('pause_physics')
        before = len(truth.messages)
        yield SimpleNamespace(moved=moved, driver=driver)
        assert len(truth.messages) <= before + 1, 'the robot moved while it was paused'
        call('unpause_physics')
        moved.wait_for(lambda m: m.data >= GOAL, 20.0, 'the goal')
        truth.wait_until_resting()


def call(service):
    """Call a service of the robot that is paused."""
    name = f'/paused/sim_turtlebot/{service}'
    rospy.wait_for_service(name, timeout=10.0)
    rospy.ServiceProxy(name, Empty)()


def resident_memory(process):
    """Return the resident memory of a process (bytes)."""
    with open(f'/proc/{process.pid}/status') as status:
        line = next(line for line in status if line.startswith('VmRSS'))
    return int(line.split()[1]) * 1024


def test_a_listener_stopped_for_a_minute_stops_nobody_else(minute):
    """The simulator keeps its pace and its memory while a listener to odom sleeps."""
    stamps = [message.header.stamp.to_sec() for message in minute.deaf.messages]
    lasted = stamps[-1] - stamps[0]
    assert lasted >= MINUTE
    assert len(stamps) == pytest.approx(lasted * ODOM_RATE, rel=0.01)
    assert minute.deaf.grown < 2e6, f'{minute.deaf.grown} bytes more'


def test_a_pause_of_a_minute_loses_nothing(minute):
    """Paused in mid-drive, the robot stands; afterwards it drives on to its goal."""
    distances = [message.data for message in minute.paused.moved.messages]
    steps = [after - before for before, after in zip(distances, distances[1:])]
    assert max(steps) < 0.01, 'the pause shows in the distance'
    assert GOAL <= distances[-1] < GOAL + 0.02
    assert 'no moved_distance arrives' in minute.paused.driver.output
