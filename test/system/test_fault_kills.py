"""Processes that are killed without warning, and come back."""

import signal
from urllib.parse import urlparse
from xmlrpc.client import ServerProxy

import pytest
import rosgraph
from geometry_msgs.msg import Twist
from odometry_tests.processes import Process
from odometry_tests.tutorial import Truth, detector, heading, mover, rotator, simulator, speed
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

BASE_TIMEOUT = 0.6  # s, a Kobuki's own watchdog
NODE_TIMEOUT = 1.0  # s, ~timeout of the nodes that drive
REACTION = 0.4  # s, to brake, to notice and to publish


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)


@pytest.fixture
def robot():
    """Start a robot at three times real time."""
    with simulator('_real_time_factor:=3') as process:
        process.truth = Truth()
        process.truth.wait_for(timeout=20.0)
        yield process


def kill(process):
    """End a process as the kernel does when memory runs out."""
    process.send(signal.SIGKILL)
    process.wait()


def stopping_time(truth, action):
    """Return how long (s, robot time) the robot moves on after an action."""
    start = truth.stamp
    action()
    return truth.wait_until_resting().header.stamp.to_sec() - start


def test_the_base_stops_when_the_mover_is_killed_and_a_new_one_goes_on(robot):
    """The base's own watchdog stops it; the distance is not lost."""
    moved = Recorder('moved_distance', Float64)
    with detector():
        with mover() as first:
            robot.truth.wait_until_moving()
            assert stopping_time(robot.truth, lambda: kill(first)) <= BASE_TIMEOUT + REACTION
        half_way = moved.last.data
        assert 0 < half_way < 2
        with mover():
            moved.wait_for(lambda m: m.data >= 2.0, 30.0, 'two metres in all')
            robot.truth.wait_until_resting()
    assert 2.0 <= moved.last.data <= 2.02


def test_the_mover_stops_when_the_detector_is_killed_and_goes_on_with_a_new_one(robot):
    """The mover's watchdog commands zero; a new detector counts from zero again."""
    with mover() as driver:
        with detector() as first:
            robot.truth.wait_until_moving()
            # The base gets no command at all from then on: whichever watchdog is first.
            assert stopping_time(robot.truth, lambda: kill(first)) <= BASE_TIMEOUT + REACTION
            driver.wait_for_output('no moved_distance arrives')
        with detector():
            robot.truth.wait_until_moving()


def test_the_movers_own_watchdog_stops_a_base_that_has_none(master):
    """Without the base's watchdog the mover's ~timeout is what stops the robot."""
    with simulator('_real_time_factor:=3', '_cmd_vel_timeout:=0', '__name:=no_watchdog'):
        truth = Truth()
        with mover(), detector() as first:
            truth.wait_until_moving()
            assert stopping_time(truth, lambda: kill(first)) <= NODE_TIMEOUT + REACTION


def test_nodes_survive_a_killed_simulator_and_drive_its_successor(robot):
    """The jump of the odometry and of the time is not counted."""
    moved = Recorder('moved_distance', Float64)
    with detector() as counter, mover('_distance:=3') as driver:
        moved.wait_for(lambda m: m.data > 0.3, 30.0, '0.3 m')
        kill(robot)
        before = moved.last.data
        with simulator('_real_time_factor:=3'):
            moved.wait_for(lambda m: m.data > before + 0.3, 30.0, '0.3 m more')
            assert counter.running and driver.running
    steps = [b.data - a.data for a, b in zip(moved.messages, moved.messages[1:])]
    assert max(steps) < 0.02, 'a jump was counted'
    assert min(steps) >= 0, 'distance was lost'


def test_the_base_stops_when_rotate_is_killed_and_a_new_one_finishes_the_turn(robot):
    """As for the mover."""
    with rotator() as first:
        robot.truth.wait_until_moving()
        assert stopping_time(robot.truth, lambda: kill(first)) <= BASE_TIMEOUT + REACTION
    assert heading(robot.truth.last) < 80
    with rotator('_tolerance:=0.5') as second:
        assert second.wait(30.0) == 0, second.output
    assert heading(robot.truth.last) == pytest.approx(90, abs=0.6)


def test_rotate_stops_a_base_without_watchdog_when_the_odometry_ceases(master):
    """The simulator is frozen, not dead; the last command before it wakes is zero."""
    with simulator('_real_time_factor:=3', '_cmd_vel_timeout:=0', '__name:=frozen') as robot:
        truth = Truth()
        truth.wait_for(timeout=20.0)
        commands = Recorder('cmd_vel', Twist)
        # Wall time: a simulated clock would stand still with its simulator.
        rosgraph.Master('/test').setParam('/use_sim_time', False)
        with rotator():
            truth.wait_until_moving()
            robot.send(signal.SIGSTOP)
            try:
                commands.wait_for(lambda m: m.angular.z == 0.0, what='a zero command')
            finally:
                robot.send(signal.SIGCONT)
            truth.wait_until_moving()


def test_roslaunch_stops_the_robot_when_it_is_interrupted(master):
    """Ctrl-C on roslaunch while the robot drives: every node ends by itself, none is killed."""
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch',
                 'real_time_factor:=3') as launch:
        truth = Truth()
        truth.wait_for(lambda m: speed(m) > 0.05, 30.0, 'a moving robot')
        assert launch.end(signal.SIGINT, timeout=20.0) == 0, launch.output
    assert 'Traceback' not in launch.output
    assert 'escalating' not in launch.output


def test_the_launch_ends_when_the_simulator_dies(master):
    """The simulator is required: without it the other nodes would wait for ever."""
    with Process('roslaunch', 'odometry_launch', 'move_two_meters.launch',
                 'real_time_factor:=3') as launch:
        Truth().wait_for(lambda m: speed(m) > 0.05, 30.0, 'a moving robot')
        pid = ServerProxy(rosgraph.Master('/test').lookupNode('/sim_turtlebot')).getPid('/test')[2]
        Process('kill', '-KILL', pid).wait()
        launch.wait(30.0)
    assert 'REQUIRED process' in launch.output
    assert 'Traceback' not in launch.output


def test_the_graph_goes_on_without_its_master_and_a_new_master_needs_new_nodes(master):
    """Connections outlive the master; who registers later needs the nodes to be started again."""
    with simulator('_real_time_factor:=3', '__name:=orphan') as robot, detector() as counter, \
            mover('_distance:=100') as driver:
        truth = Truth()
        truth.wait_until_moving()
        master.end(signal.SIGINT, timeout=20.0)
        wait_until(lambda: not rosgraph.is_master_online(), 5.0, 'a master that is gone')
        truth.clear()
        moving = truth.wait_for(lambda m: speed(m) > 0.05, 10.0, 'a robot that still drives')
        truth.wait_for(lambda m: m.header.stamp.to_sec() > moving.header.stamp.to_sec() + 3, 10.0,
                       'three seconds of driving without a master')
        for process in (driver, counter, robot):
            assert process.end() == 0, process.output
            assert 'Traceback' not in process.output
    port = urlparse(rosgraph.get_master_uri()).port
    with Process('roscore', '-p', port):
        wait_until(rosgraph.is_master_online, 20.0, 'a new master')
        assert not any(topic == '/odom' for topic, _ in rosgraph.Master('/test').getTopicTypes())
        with simulator():
            wait_until(lambda: ['/odom', 'nav_msgs/Odometry']
                       in rosgraph.Master('/test').getTopicTypes(), 20.0, 'a new robot on it')
