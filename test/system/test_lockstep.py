"""In lockstep a run as fast as the machine can has no control delay and can be repeated."""

import contextlib
import io
import itertools
import signal

import numpy
import pytest
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.pausing import call, pause
from odometry_tests.placing import Placer
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import (
    Truth,
    detector,
    forget_parameters,
    mover,
    rotator,
    simulator_in_step,
)
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from sensor_msgs.msg import Imu, JointState, LaserScan
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage

PERIOD = 0.05  # s, of the odometry
COMPARED = 24  # s of simulated time; two metres take 20
RUN_TIME = 60.0  # s
PATIENCE = 30.0  # s of wall time for a controller that the machine lets wait
GAVE_UP = 'lockstep: no command for'
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


def record(rate, starts, topics, arguments=(), prepare=lambda: None):
    """Run nodes in lockstep; return the messages on each topic, from time zero on.

    :param starts: functions that start the nodes beside the simulator
    :param topics: message class and number of messages by topic; repetitions of the first one do
        not count
    :param arguments: for the simulator
    :param prepare: function that is called before time begins
    """
    with contextlib.ExitStack() as stack:
        simulation = stack.enter_context(simulator_in_step(
            UNPACED, '_paused:=true', *arguments, rate=rate, patience=PATIENCE))
        for start in starts:
            stack.enter_context(start())
        # Closed, so that the next run's do not hear what comes late.
        recorders = {topic: stack.enter_context(contextlib.closing(Recorder(topic, kind)))
                     for topic, (kind, _) in topics.items()}
        for recorder in recorders.values():
            recorder.wait_for_publisher()
        prepare()
        call('unpause_physics')
        for topic, (_, count) in topics.items():
            wait_until(lambda topic=topic, count=count:
                       len(from_time_zero(recorders[topic].messages)) >= count,
                       RUN_TIME, f'{count} messages on {topic}', period=0.1)
        assert GAVE_UP not in simulation.output, simulation.output
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


def put_elsewhere():
    """Put the robot at another place, and look to another side."""
    truth = Truth()
    placer = Placer()
    truth.wait_for_publisher()  # while time stands still, the robot is shown there once
    placer.put(1.5, -2.0, yaw=2.0)
    truth.wait_for(lambda m: m.pose.pose.position.x == 1.5, what='a robot at x 1.5 m')


MOVE = 20, [detector, mover], {
    '/odom': (Odometry, 20 * COMPARED), '/moved_distance': (Float64, 20 * COMPARED),
    # The mover's commands are all the same until it arrives, so that most are repetitions.
    '/cmd_vel': (Twist, 80)}
SENSORS = (
    20, [detector, mover],
    {'/odom': (Odometry, 20 * COMPARED),
     '/scan': (LaserScan, 10 * COMPARED),
     '/mobile_base/sensors/imu_data': (Imu, 20 * COMPARED),
     '/joint_states': (JointState, 20 * COMPARED)},
    ['_scan:=true', '_scan_noise:=0.01', f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf',
     '_x:=-1.0'])
ELSEWHERE = *MOVE, (), put_elsewhere
ROTATE = 10, [rotator], {'/odom': (Odometry, 20 * COMPARED), '/cmd_vel': (Twist, 10 * COMPARED)}


@pytest.fixture(scope='module')
def two_metres():
    """Record a drive of two metres."""
    return record(*MOVE)


@pytest.mark.parametrize('tutorial', [MOVE, ELSEWHERE, ROTATE, SENSORS],
                         ids=['move', 'elsewhere', 'rotate', 'sensors'])
def test_two_runs_are_the_same_bytes(two_metres, tutorial):
    """Each message on each topic, from the first to the last."""
    first = two_metres if tutorial is MOVE else record(*tutorial)
    second = record(*tutorial)
    for topic, messages in first.items():
        different = [index for index, pair in enumerate(zip(messages, second[topic]))
                     if bytes_of(pair[0]) != bytes_of(pair[1])]
        assert not different, (f'{topic}: message {different[0]} is the first that differs:\n'
                               f'{messages[different[0]]}\n\n{second[topic][different[0]]}')


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


def test_a_controller_that_falls_silent_does_not_stop_the_time():
    """After its patience the simulation goes on, and says so once."""
    with simulator_in_step(UNPACED, patience=5) as simulation, detector(), mover() as driver:
        odometry = Recorder('odom', Odometry)
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > 1, 20.0, 'a running simulation')
        driver.send(signal.SIGKILL)
        driver.wait()
        silent_from = odometry.last.header.stamp.to_sec()
        odometry.wait_for(lambda m: m.header.stamp.to_sec() > silent_from + 10, 20.0,
                          'ten seconds more')
        simulation.wait_for_output(f'{GAVE_UP} 5 s')
        assert odometry.last.twist.twist.linear.x == 0.0
    assert simulation.output.count(GAVE_UP) == 1


def test_simulated_time_stands_still_until_the_first_command():
    """The odometry is repeated meanwhile, the same message again."""
    with simulator_in_step(UNPACED):
        seen = Recorder('odom', Odometry).wait_for_count(4, 20.0)
    assert seen[0].header.stamp.to_sec() == 0
    assert all(message == seen[0] for message in seen)


def time_reached(odometry):
    """Return how far time goes (s) before it waits for another command."""
    odometry.wait_for(lambda m: m.header.stamp.to_sec() > 0, 30.0, 'the next odometry')
    pause(odometry)
    return max(m.header.stamp.to_sec() for m in odometry.messages)


def test_a_late_answer_to_a_repetition_is_not_one_to_the_next_odometry():
    """Also if the first command is read in a pause, and not while it is waited for."""
    with simulator_in_step(UNPACED, patience=PATIENCE):
        odometry = Recorder('odom', Odometry)
        odometry.wait_for_count(3, 20.0)
        commands = rospy.Publisher('cmd_vel', Twist, queue_size=2)
        wait_for_subscribers(commands)
        for service in 'pause_physics', 'unpause_physics':
            call(service)
            commands.publish(Twist())
        assert time_reached(odometry) == PERIOD


def test_an_answer_to_what_is_shown_in_a_pause_is_not_one_to_the_next_odometry():
    """A robot that is put somewhere is shown there, and who hears that commands."""
    with simulator_in_step(UNPACED, '_paused:=true', patience=PATIENCE):
        odometry = Recorder('odom', Odometry)
        odometry.wait_for_publisher()
        commands = rospy.Publisher('cmd_vel', Twist, queue_size=2)
        wait_for_subscribers(commands)
        Placer().put(1.0, 0.0)
        odometry.wait_for(what='a robot that was put')
        commands.publish(Twist())
        call('unpause_physics')
        commands.publish(Twist())
        assert time_reached(odometry) == PERIOD


def test_an_answer_from_before_a_reset_is_not_one_to_time_zero():
    """Whoever resets cannot know whether one is under way."""
    with simulator_in_step(UNPACED, '_paused:=true', patience=PATIENCE):
        odometry = Recorder('odom', Odometry)
        odometry.wait_for_publisher()
        commands = rospy.Publisher('cmd_vel', Twist, queue_size=2)
        wait_for_subscribers(commands)
        call('unpause_physics')
        commands.publish(Twist())
        assert time_reached(odometry) == PERIOD
        odometry.clear()
        for service in 'unpause_physics', 'reset_simulation':
            call(service)
        for _ in 'late', 'in time':
            commands.publish(Twist())
        assert time_reached(odometry) == PERIOD


def test_while_time_stands_still_a_line_says_what_it_waits_for():
    """And tf is sent once to each who listens: tf warns of what it knows already."""
    with simulator_in_step(UNPACED) as simulation:
        odometry = Recorder('odom', Odometry)
        transforms = Recorder('/tf', TFMessage)
        odometry.wait_for_count(2, 20.0)
        transforms.wait_for(what='the transform of a robot that has not moved')
        line = ('lockstep: time stands still until there is a first command on /cmd_vel, '
                '/mobile_base/commands/velocity')
        wait_until(lambda: simulation.output.count(line) >= 2, 20.0,
                   lambda: f'the line twice in:\n{simulation.output}')
        odometry.wait_for_count(11, 20.0)
        assert len(transforms.messages) == 1
        commands = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        wait_until(lambda: commands.publish(Twist()) or odometry.last.header.stamp.to_sec() > 0,
                   20.0, 'a running simulation')


def test_many_robots_are_named_in_short():
    """The first topics, and how many there are."""
    with simulator_in_step(UNPACED, '_robots:=3') as simulation:
        simulation.wait_for_output(
            'a first command on /robot_1/cmd_vel, /robot_1/mobile_base/commands/velocity, '
            '/robot_1/cmd_vel_mux/input/teleop, /robot_1/cmd_vel_mux/input/navi, ... (12 topics)')


def test_two_clocks_lead_to_the_same_odometry():
    """However finely the clock ticks: the same bytes."""
    coarse, fine = (record(20, [detector, mover], {'/odom': (Odometry, 100)}, clock)
                    for clock in ([], ['_clock_rate:=170']))
    assert [bytes_of(m) for m in coarse['/odom']] == [bytes_of(m) for m in fine['/odom']]
