"""What the simulator publishes, by the contract."""

import math
from types import SimpleNamespace

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.robots import Robot, place
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from tf2_msgs.msg import TFMessage

QUICK = '_real_time_factor:=5'
START = 1.0, -2.0, 1.5  # m, m, rad; where the robot in the corner starts
TUTORIAL_VARIANCES = [1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001]


def simulator_in(namespace, *arguments):
    return simulator(QUICK, *arguments, env={'ROS_NAMESPACE': namespace})


@pytest.fixture(scope='module')
def robots(master):
    """Return one robot alone, one that starts in a corner, and a pair in one world."""
    rospy.set_param('/use_sim_time', True)
    corner = [f'_{name}:={value}' for name, value in zip(('x', 'y', 'yaw'), START)]
    with simulator_in('alone'), simulator_in('corner', '_cmd_vel_timeout:=0', *corner), \
            simulator_in('shared', '_robots:=2'):
        tf = Recorder('/tf', TFMessage)
        alone, in_corner, *pair = map(
            Robot, ('alone/', 'corner/', 'shared/robot_1/', 'shared/robot_2/'))
        for robot in (alone, in_corner, *pair):
            robot.wait_until_ready()
        yield SimpleNamespace(alone=alone, corner=in_corner, pair=pair, tf=tf)


def step(robot, count, *speeds):
    """Command the robot so many times; return the odometry that follows each command."""
    seen = [robot.odometry.last]
    for _ in range(count):
        robot.drive(*speeds)
        seen.append(robot.odometry.wait_for(lambda m: m.header.seq > seen[-1].header.seq))
    return seen[1:]


def sender(message):
    return message._connection_header['callerid']


def frames(message):
    """Return a message's frame and that of its child."""
    return message.header.frame_id, message.child_frame_id


def test_odometry_has_the_fields_of_the_tutorial_and_starts_at_zero(robots):
    """Ground truth is in the world, odometry from the start on."""
    message, truth = robots.corner.restart()
    assert frames(message) == ('odom', 'base_footprint')
    assert list(message.pose.covariance[::7]) == TUTORIAL_VARIANCES
    assert sum(map(abs, message.pose.covariance)) == sum(TUTORIAL_VARIANCES)
    assert set(message.twist.covariance) == {0.0}
    assert place(message) == (0.0, 0.0, 0.0) and message.twist.twist == Twist()
    orientation = message.pose.pose.orientation
    assert math.hypot(orientation.x, orientation.y, orientation.z, orientation.w) == pytest.approx(1.0)
    assert frames(truth) == ('world', 'base_footprint') and place(truth) == START
    robots.corner.drive(0.5)
    robots.corner.odometry.wait_for(lambda m: place(m)[0] >= 0.5, what='half a metre')
    assert place(robots.corner.odometry.last)[1:] == (0.0, 0.0)


def test_number_and_stamp_advance_twenty_times_a_second(robots):
    """The number is the stamp's: 20 for each second since the start."""
    stepped = step(robots.alone, 40, 0.0)
    for message in stepped + robots.corner.odometry.messages:
        assert message.header.stamp.to_nsec() == message.header.seq * 50_000_000
    numbers = [message.header.seq for message in stepped]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_tf_repeats_the_odometry(robots):
    """From odom to base_footprint, with the same stamp; the wheels are behind it."""
    message = step(robots.alone, 3, 0.2, 0.5)[-1]
    transform = robots.tf.wait_for(lambda m: sender(m) == '/alone/sim_turtlebot' and
                                   m.transforms[0].header.stamp == message.header.stamp).transforms[0]
    assert frames(transform) == ('odom', 'base_footprint')
    position, moved = message.pose.pose.position, transform.transform.translation
    assert (moved.x, moved.y, moved.z) == (position.x, position.y, position.z)
    assert transform.transform.rotation == message.pose.pose.orientation


def test_two_robots_share_a_world(robots):
    """Each with its own namespace and frames; each obeys its own commands only."""
    first, second = robots.pair
    own = [frames(robot.odometry.last) for robot in robots.pair]
    assert own == [(f'robot_{number}/odom', f'robot_{number}/base_footprint') for number in (1, 2)]
    found = robots.tf.wait_for(lambda m: sender(m) == '/shared/sim_turtlebot')
    assert own == [frames(transform) for transform in found.transforms[:2]]
    assert place(first.truth.last) == (0.0, 0.0, 0.0)
    assert place(second.truth.last) == (0.0, 1.0, 0.0)
    second.drive(0.3)
    second.truth.wait_until_moving()
    assert place(first.truth.last) == (0.0, 0.0, 0.0)


def test_without_simulated_time_the_stamps_are_the_walls(robots):
    """And it publishes no clock."""
    rospy.set_param('/use_sim_time', False)
    start = rospy.Time.now()
    with simulator(env={'ROS_NAMESPACE': 'wall'}):
        stamp = Recorder('/wall/odom', Odometry).wait_for(timeout=20.0).header.stamp
        publishers = dict(rosgraph.Master('/test').getSystemState()[0])
    assert start < stamp < rospy.Time.now()
    assert '/wall/sim_turtlebot' in publishers['/wall/odom']
    assert '/wall/sim_turtlebot' not in publishers['/clock']
