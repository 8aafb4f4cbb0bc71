"""In lockstep a run as fast as the machine can has no control delay and can be repeated."""

import itertools
import signal

import numpy
import pytest
import rosbag
import rosgraph
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process, rosrun
from odometry_tests.waiting import Recorder
from std_msgs.msg import Float64

TOPICS = {'/odom': Odometry, '/moved_distance': Float64, '/cmd_vel': Twist}
SECONDS, COMPARED = 25, 24  # of simulated time; two metres take 20
MOST_MISSED = 10  # messages at the beginning


@pytest.fixture(autouse=True)
def simulated_time(master):
    """Let the nodes follow the simulator's clock."""
    rosgraph.Master('/test').setParam('/use_sim_time', True)


def record(path, launch_file):
    """Run a tutorial in lockstep and put its messages into a bag."""
    recorders = {topic: Recorder(topic, kind) for topic, kind in TOPICS.items()}
    with Process('roslaunch', 'odometry_launch', launch_file, 'lockstep:=true',
                 'real_time_factor:=0'):
        recorders['/odom'].wait_for(
            lambda message: message.header.stamp.to_sec() > SECONDS, 60.0, f'{SECONDS} s')
    with rosbag.Bag(str(path), 'w') as bag:
        for topic, recorder in recorders.items():
            for message in recorder.messages:
                bag.write(topic, message)


def messages_in(path, topic):
    """Return the bytes of the messages on a topic up to the end of the comparison.

    Until the first command the simulator repeats the odometry; how often depends on how long
    the nodes take to start. These repetitions are left out.
    """
    with rosbag.Bag(str(path)) as bag:
        everything = [raw[1] for _, raw, _ in bag.read_messages(topic, raw=True)]
    first = everything[:1]
    return first + list(itertools.dropwhile(lambda message: message == first[0], everything))


def without_missed(first, second):
    """Drop the messages with which one begins, while the other's recorder was still connecting."""
    for missed in range(MOST_MISSED):
        if first[missed] == second[0]:
            return first[missed:], second
        if second[missed] == first[0]:
            return first, second[missed:]
    return first, second


@pytest.mark.parametrize('launch_file, counts', [
    # The mover's commands are all the same until it arrives, so that most count as repetitions.
    ('move_two_meters.launch',
     {'/odom': 20 * COMPARED, '/moved_distance': 20 * COMPARED, '/cmd_vel': 80}),
    ('rotate.launch', {'/odom': 20 * COMPARED, '/cmd_vel': 10 * COMPARED})])
def test_two_runs_are_the_same_bytes(master, tmp_path, launch_file, counts):
    """Each message on each topic, from the first to the last."""
    bags = [tmp_path / 'first.bag', tmp_path / 'second.bag']
    for bag in bags:
        record(bag, launch_file)
    for topic, count in counts.items():
        first, second = without_missed(*(messages_in(bag, topic) for bag in bags))
        first, second = first[:count], second[:count]
        assert len(first) == len(second) == count
        different = [index for index in range(count) if first[index] != second[index]]
        assert not different, f'{topic}: message {different[0]} is the first that differs'


@pytest.fixture(scope='module')
def drive(master, tmp_path_factory):
    """Record a drive of two metres; return its odometry and its distances."""
    path = tmp_path_factory.mktemp('drive') / 'run.bag'
    rosgraph.Master('/test').setParam('/use_sim_time', True)
    record(path, 'move_two_meters.launch')
    with rosbag.Bag(str(path)) as bag:
        return ([message for _, message, _ in bag.read_messages('/odom')],
                [message.data for _, message, _ in bag.read_messages('/moved_distance')])


def test_the_zero_command_comes_at_the_odometry_that_reaches_two_metres(drive):
    """No control delay: the robot brakes from the very odometry on that has seen two metres."""
    odometry, distances = drive
    arrived = next(m for m in odometry if m.pose.pose.position.x >= 2.0)
    following = next(m for m in odometry if m.header.seq == arrived.header.seq + 1)
    assert following.twist.twist.linear.x < 0.05, 'still driving one period later'
    assert 2.0 <= distances[-1] <= 2.006


def test_the_distance_is_the_sum_of_the_recorded_steps(drive):
    """Added up once more with numpy, from the bag."""
    odometry, distances = drive
    positions = [message.pose.pose.position for message in odometry]
    ways = numpy.diff([(position.x, position.y) for position in positions], axis=0)
    assert distances[-1] == pytest.approx(numpy.hypot(*ways.T).sum(), rel=1e-12)


def test_a_controller_that_falls_silent_does_not_stop_the_time(master):
    """After two seconds the simulation goes on, and says so once."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '_lockstep_rate:=20',
                '_real_time_factor:=0', '_odom_rate:=20') as simulator, \
            rosrun('odom_movement_detector', 'odom_movement_detector.py'), \
            rosrun('test_movement', 'test_movement.py') as mover:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > 1, 20.0, 'a running simulation')
        mover.send(signal.SIGKILL)
        mover.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        simulator.wait_for_output('lockstep: no command for')
        assert odometry.last.twist.twist.linear.x == 0.0
    assert simulator.output.count('lockstep: no command for') == 1


def test_simulated_time_stands_still_until_the_first_command(master):
    """The odometry is repeated meanwhile, the same message again."""
    with rosrun('sim_turtlebot', 'sim_turtlebot_node.py', '_lockstep_rate:=20',
                '_real_time_factor:=0'):
        seen = Recorder('odom', Odometry).wait_for_count(4, 20.0)
    assert seen[0].header.stamp.to_sec() == 0
    assert all(message == seen[0] for message in seen)
