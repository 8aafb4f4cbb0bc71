"""In lockstep a run as fast as the machine can has no control delay and can be repeated."""

import contextlib
import io
import itertools
import signal

import numpy
import pytest
import rosgraph
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call
from odometry_tests.processes import rosrun
from odometry_tests.waiting import Recorder, wait_until
from std_msgs.msg import Float64

COMPARED = 24  # s of simulated time; two metres take 20
RUN_TIME = 60.0  # s
PATIENCE = 10.0  # s of wall time for a controller that the machine lets wait
DETECTOR = 'odom_movement_detector', 'odom_movement_detector.py'
MOVER = 'test_movement', 'test_movement.py'
ROTATOR = 'rotate_robot', 'rotate.py'


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)


def simulator(rate=20, patience=PATIENCE):
    """Start a simulator in lockstep, as fast as the machine can."""
    return rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '_real_time_factor:=0',
                  f'_lockstep_rate:={rate}', f'_lockstep_patience:={patience}')


def record(rate, nodes, topics):
    """Run nodes in lockstep; return the messages on each topic, from time zero on.

    :param topics: message class and number of messages by topic; repetitions of the first one do
        not count
    """
    with contextlib.ExitStack() as stack:
        stack.enter_context(simulator(rate))
        call('pause_physics')  # until everybody listens
        for node in nodes:
            stack.enter_context(rosrun(*node))
        recorders = {topic: Recorder(topic, kind) for topic, (kind, _) in topics.items()}
        for recorder in recorders.values():
            recorder.wait_for_publisher()
        call('unpause_physics')
        for topic, (_, count) in topics.items():
            wait_until(lambda topic=topic, count=count:
                       len(from_time_zero(recorders[topic].messages)) >= count,
                       RUN_TIME, f'{count} messages on {topic}', period=0.1)
        return {topic: from_time_zero(recorders[topic].messages)[:count]
                for topic, (_, count) in topics.items()}


def from_time_zero(messages):
    """Return the messages with the first one only once.

    Until the first command the simulator repeats the odometry; how often depends on how long
    the nodes take to start.
    """
    return messages[:1] + list(itertools.dropwhile(lambda m: m == messages[0], messages))


def bytes_of(message):
    """Return a message as it is sent."""
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


MOVE = 20, [DETECTOR, MOVER], {
    '/odom': (Odometry, 20 * COMPARED), '/moved_distance': (Float64, 20 * COMPARED),
    # The mover's commands are all the same until it arrives, so that most are repetitions.
    '/cmd_vel': (Twist, 80)}
ROTATE = 10, [ROTATOR], {'/odom': (Odometry, 20 * COMPARED), '/cmd_vel': (Twist, 10 * COMPARED)}


@pytest.mark.parametrize('tutorial', [MOVE, ROTATE], ids=['move', 'rotate'])
def test_two_runs_are_the_same_bytes(master, tutorial):
    """Each message on each topic, from the first to the last."""
    first, second = record(*tutorial), record(*tutorial)
    for topic, messages in first.items():
        different = [index for index, pair in enumerate(zip(messages, second[topic]))
                     if bytes_of(pair[0]) != bytes_of(pair[1])]
        assert not different, f'{topic}: message {different[0]} is the first that differs'


@pytest.fixture(scope='module')
def drive(master):
    """Record a drive of two metres; return its odometry and its distances."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)
    messages = record(*MOVE)
    return messages['/odom'], [message.data for message in messages['/moved_distance']]


def test_the_zero_command_comes_at_the_odometry_that_reaches_two_metres(drive):
    """No control delay: the robot brakes from the very odometry on that has seen two metres."""
    odometry, distances = drive
    arrived = next(m for m in odometry if m.pose.pose.position.x >= 2.0)
    following = next(m for m in odometry if m.header.seq == arrived.header.seq + 1)
    assert following.twist.twist.linear.x < 0.05, 'still driving one period later'
    assert 2.0 <= distances[-1] <= 2.006


def test_the_distance_is_the_sum_of_the_recorded_steps(drive):
    """Added up once more with numpy."""
    odometry, distances = drive
    positions = [message.pose.pose.position for message in odometry]
    ways = numpy.diff([(position.x, position.y) for position in positions], axis=0)
    assert distances[-1] == pytest.approx(numpy.hypot(*ways.T).sum(), rel=1e-12)


def test_a_controller_that_falls_silent_does_not_stop_the_time(master):
    """After its patience the simulation goes on, and says so once."""
    with simulator(patience=5.0) as simulation, rosrun(*DETECTOR), rosrun(*MOVER) as mover:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > 1, 20.0, 'a running simulation')
        mover.send(signal.SIGKILL)
        mover.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        simulation.wait_for_output('lockstep: no command for 5 s')
        assert odometry.last.twist.twist.linear.x == 0.0
    assert simulation.output.count('lockstep: no command for') == 1


def test_simulated_time_stands_still_until_the_first_command(master):
    """The odometry is repeated meanwhile, the same message again."""
    with simulator():
        seen = Recorder('odom', Odometry).wait_for_count(4, 20.0)
    assert seen[0].header.stamp.to_sec() == 0
    assert all(message == seen[0] for message in seen)
