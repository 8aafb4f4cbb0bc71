"""In lockstep a run as fast as the machine can has no control delay, and two are the same bytes."""

import contextlib
import io
import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy
import pytest
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call
from odometry_tests.placing import Placer
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import (
    Truth,
    detector,
    forget_parameters,
    mover,
    rotator,
    simulator,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder, wait_until
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Imu, JointState, LaserScan
from sim_turtlebot.lockstep import Lockstep
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage

COMPARED = 24  # s of simulated time; two metres take 20
RUN_TIME = 60.0  # s
NOT_AWAITED = 'lockstep does not wait for'
HERE = Path(__file__).parent
# The nodes beside the simulator, the first of which commands; C++ is compiled from client.cpp.
CLIENTS = {
    'rospy.Rate(10)': ['rate 10'], 'rospy.Rate(30)': ['rate 30'], 'rospy.Timer': ['timer'],
    'rospy.sleep': ['sleep'], 'rospy.wait_for_message': ['wait_for_message'],
    'tf': ['tf_listener'], 'tf2_ros': ['tf2_listener'], 'message_filters': ['synchronizer'],
    'service': ['service'], 'latched topic': ['latched', 'latching'],
    'actionlib': ['action', 'action_server'], 'dynamic_reconfigure': ['reconfigure', 'tuner'],
    'rosbag record': ['rate 20', 'bag'],
    'ros::Rate': ['C++ rate'], 'ros::Timer': ['C++ timer'],
    'ros::MultiThreadedSpinner': ['C++ spinners']}
CLIENT_TIME = 5  # s of simulated time
LEAST_COMMANDS = 10
UNPACED = '_real_time_factor:=0'


@pytest.fixture(scope='module', autouse=True)
def simulated_clock(master):
    """Let the nodes follow the simulator's clock."""
    rospy.set_param('/use_sim_time', True)


@pytest.fixture(autouse=True)
def defaults():
    """Leave no parameter to the next test."""
    yield
    forget_parameters()


def record(starts, topics, arguments=(), prepare=lambda: None):
    """Run nodes in lockstep; return the messages on each topic, from time zero on.

    :param starts: functions that start the nodes beside the simulator
    :param topics: message class and number of messages by topic
    :param arguments: for the simulator
    :param prepare: function that is called before time begins
    """
    with contextlib.ExitStack() as stack:
        simulation = stack.enter_context(simulator_in_step(UNPACED, '_paused:=true', *arguments))
        for start in starts:
            stack.enter_context(start())
        # Closed, so that the next run's do not hear what comes late.
        recorders = {topic: stack.enter_context(contextlib.closing(Recorder(topic, kind)))
                     for topic, (kind, _) in topics.items()}
        for recorder in recorders.values():
            recorder.wait_for_publisher()
        prepare()
        wait_until_settled()
        for recorder in recorders.values():
            recorder.clear()
        call('unpause_physics')
        for topic, (_, count) in topics.items():
            recorders[topic].wait_for_count(count, RUN_TIME)
        assert NOT_AWAITED not in simulation.output, simulation.output
        return {topic: recorders[topic].messages[:count] for topic, (_, count) in topics.items()}


def wait_until_settled():
    """Return when all nodes have done what they do before time begins."""
    graph = Lockstep(lambda: False)
    wait_until(graph.has_settled, RUN_TIME, 'nodes at rest')


def bytes_of(message):
    """Return a message as it is sent."""
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def put_elsewhere():
    """Put the robot at another place, and look to another side."""
    truth = Truth()
    placer = Placer()
    truth.wait_for_publisher()  # while time stands still, the robot is shown there once
    placer.put(1.5, -2.0, yaw=2.0)
    truth.wait_for(lambda m: m.pose.pose.position.x == 1.5, what='a robot at x 1.5 m')


MOVE = [detector, mover], {
    '/odom': (Odometry, 20 * COMPARED), '/moved_distance': (Float64, 20 * COMPARED),
    '/cmd_vel': (Twist, 20 * COMPARED)}
SENSORS = (
    [detector, mover],
    {'/odom': (Odometry, 20 * COMPARED),
     '/scan': (LaserScan, 10 * COMPARED),
     '/mobile_base/sensors/imu_data': (Imu, 20 * COMPARED),
     '/joint_states': (JointState, 20 * COMPARED)},
    ['_scan:=true', '_scan_noise:=0.01', f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf',
     '_x:=-1.0'])
ELSEWHERE = *MOVE, (), put_elsewhere
ROTATE = [rotator], {'/odom': (Odometry, 20 * COMPARED), '/cmd_vel': (Twist, 10 * COMPARED)}


@pytest.fixture(scope='module')
def start_client(tmp_path_factory):
    """Return a function that starts a node of a kind, with a name; C++ is compiled at its first use."""
    folder = tmp_path_factory.mktemp('clients')

    def start(kind, name):
        language, _, argument = kind.partition(' ')
        if kind == 'bag':
            command = 'rosbag', 'record', '-O', folder / 'run', '/odom'
        elif language == 'C++':
            command = compile_client(folder / 'client'), argument
        else:
            command = sys.executable, HERE / 'clients.py', kind
        return Process(*command, f'__name:={name}')

    return start


def compile_client(path):
    """Compile the client in C++, unless it is there, and return its path."""
    if not path.exists():
        flags = subprocess.run(['pkg-config', '--cflags', '--libs', 'roscpp'], check=True, text=True,
                               stdout=subprocess.PIPE).stdout.split()
        subprocess.run(['g++', '-o', path, HERE / 'client.cpp', *flags], check=True)
    return path


@pytest.fixture(scope='module')
def two_metres():
    """Record a drive of two metres."""
    return record(*MOVE)


def assert_same_bytes(first, second):
    """Assert that two runs have the same messages, each to the byte."""
    for topic, messages in first.items():
        different = [index for index, pair in enumerate(zip(messages, second[topic]))
                     if bytes_of(pair[0]) != bytes_of(pair[1])]
        assert not different, (f'{topic}: message {different[0]} is the first that differs:\n'
                               f'{messages[different[0]]}\n\n{second[topic][different[0]]}')


@pytest.mark.parametrize('tutorial', [MOVE, ELSEWHERE, ROTATE, SENSORS],
                         ids=['move', 'elsewhere', 'rotate', 'sensors'])
def test_two_runs_are_the_same_bytes(two_metres, tutorial):
    """Each message on each topic, from the first to the last."""
    first = two_metres if tutorial is MOVE else record(*tutorial)
    assert_same_bytes(first, record(*tutorial))


@pytest.mark.parametrize('client', CLIENTS)
def test_two_runs_with_any_node_are_the_same_bytes(client, start_client):
    """Whatever it waits for: the clock, a message, a service, a transform; with the default clock."""
    kinds = CLIENTS[client]
    names = ['client', *kinds[1:]]
    starts = [partial(start_client, *pair) for pair in zip(kinds, names)]
    topics = {'/odom': (Odometry, 20 * CLIENT_TIME), '/tf': (TFMessage, 20 * CLIENT_TIME),
              '/cmd_vel': (Twist, LEAST_COMMANDS)}
    assert_same_bytes(*(record(starts, topics, ['_clock_rate:=100']) for _ in range(2)))


@pytest.mark.parametrize('rate', [5, 10, 20, 30, 50, 100])
def test_a_loop_keeps_its_rate(rate, start_client):
    """In simulated time, with the default clock: so many commands in ten seconds."""
    with simulator('_lockstep:=true', UNPACED, '_paused:=true'), \
            start_client(f'rate {rate}', 'client'), \
            contextlib.closing(Recorder('/cmd_vel', Twist)) as commands, \
            contextlib.closing(Recorder('/clock', Clock)) as clock:
        commands.wait_for_publisher()
        clock.wait_for_publisher()
        call('unpause_physics')
        counts = []
        for second in 2, 12:
            clock.wait_for(lambda m, second=second: m.clock.to_sec() >= second, RUN_TIME)
            counts.append(len(commands.messages))
    # A command of either moment may have come before or after this thread looked.
    assert abs(counts[1] - counts[0] - 10 * rate) <= 1 + rate / 10, counts


def test_the_zero_command_comes_at_the_odometry_that_reaches_two_metres(two_metres):
    """No control delay: the robot brakes from the very odometry on that has seen two metres."""
    odometry = two_metres['/odom']
    arrived = next(m for m in odometry if m.pose.pose.position.x >= 2.0)
    following = next(m for m in odometry if m.header.seq == arrived.header.seq + 1)
    assert following.twist.twist.linear.x < 0.05, 'still driving one period later'
    assert 2.0 <= two_metres['/moved_distance'][-1].data <= 2.006


def test_the_distance_is_the_sum_of_the_recorded_steps(two_metres):
    """Added up once more with numpy."""
    positions = [message.pose.pose.position for message in two_metres['/odom']]
    steps = numpy.diff([(position.x, position.y) for position in positions], axis=0)
    assert two_metres['/moved_distance'][-1].data == pytest.approx(
        numpy.hypot(*steps.T).sum(), rel=1e-12)


def test_a_mover_that_is_killed_does_not_stop_the_time():
    """Nor does it have to be named."""
    with simulator_in_step(UNPACED) as simulation, detector(), mover() as driver:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > 1, 20.0, 'a running simulation')
        driver.send(signal.SIGKILL)
        driver.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        assert odometry.last.twist.twist.linear.x == 0.0
    assert NOT_AWAITED not in simulation.output


@pytest.mark.parametrize('kind, reason', [
    ('busy', 'it has not rested for 2 s'), ('wall', 'it sleeps by wall time')])
def test_who_cannot_be_waited_for_is_named_once_and_time_goes_on(kind, reason, start_client):
    """With what to do."""
    with simulator_in_step('_real_time_factor:=5') as simulation, \
            start_client(kind, 'culprit'):
        simulation.wait_for_output(f'{NOT_AWAITED} /culprit, so that two runs may differ: {reason}',
                                   60.0)
        truth = Truth()
        truth.wait_seconds(10.0)
        assert simulation.output.count(f'{NOT_AWAITED} /culprit') == 1


def test_time_is_the_same_for_who_sleeps_on_the_clock_before_it_commands(start_client):
    """Nobody has to speak first."""
    with simulator_in_step(UNPACED), start_client('sleeper', 'sleeper') as sleeper:
        sleeper.wait_for_output('awake')


def test_two_clocks_lead_to_the_same_odometry():
    """However finely the clock ticks: the same bytes."""
    coarse, fine = (record([detector, mover], {'/odom': (Odometry, 100)}, clock)
                    for clock in ([], ['_clock_rate:=170']))
    assert [bytes_of(m) for m in coarse['/odom']] == [bytes_of(m) for m in fine['/odom']]
