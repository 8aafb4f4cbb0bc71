"""What the simulator publishes, by the contract."""

import math

import pytest
import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import stamp
from odometry_tests.robots import Robot, place
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from rosgraph_msgs.msg import Log
from tf2_msgs.msg import TFMessage

START = 1.0, -2.0, 1.5  # m, m, rad; where the robot in the corner starts
TUTORIAL_VARIANCES = [1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001]


@pytest.fixture(scope='module')
def corner(master):
    """Return a robot that starts in a corner, and that only a command stops."""
    rospy.set_param('/use_sim_time', True)
    with simulator('__ns:=corner', '_real_time_factor:=5', '_clock_rate:=20', '_cmd_vel_timeout:=0',
                   '_x:=1', '_y:=-2', '_yaw:=1.5'):
        robot = Robot('corner/')
        robot.wait_until_ready()
        yield robot
    rospy.set_param('/use_sim_time', False)


def test_odometry_has_the_fields_of_the_tutorial_and_starts_at_zero(corner):
    """Ground truth is in the world, odometry from the start on."""
    message, truth = corner.restart()
    assert (message.header.frame_id, message.child_frame_id) == ('odom', 'base_footprint')
    assert list(message.pose.covariance[::7]) == TUTORIAL_VARIANCES
    assert sum(map(abs, message.pose.covariance)) == sum(TUTORIAL_VARIANCES)
    assert set(message.twist.covariance) == {0.0} and message.twist.twist == Twist()
    assert (truth.header.frame_id, truth.child_frame_id) == ('world', 'base_footprint')
    assert (place(truth), place(message)) == (START, (0.0, 0.0, 0.0))
    corner.drive(0.5)
    corner.odometry.wait_for(lambda m: place(m)[0] >= 0.5, what='half a metre')
    assert place(corner.odometry.last)[1:] == (0.0, 0.0)


def test_a_command_that_is_not_finite_is_refused_and_stops_the_robot(corner):
    log = Recorder('/rosout', Log)
    log.wait_for_publisher()
    corner.restart()
    corner.drive(0.3, 0.5)
    corner.truth.wait_until_moving()
    corner.drive(math.nan)
    corner.truth.wait_until_resting()
    log.wait_for(lambda m: m.level == Log.WARN and 'is not finite' in m.msg)


def test_tf_repeats_the_odometry(corner):
    """From odom to base_footprint, with the same stamp; the wheels are behind it."""
    corner.restart()
    transforms = Recorder('/tf', TFMessage)
    transforms.wait_for_publisher()
    corner.drive(0.2, 0.5)
    message = corner.odometry.wait_for(lambda m: abs(m.pose.pose.position.y) > 0.01, what='a turn')
    transform = transforms.wait_for(lambda m: stamp(m) == stamp(message)).transforms[0]
    pose = message.pose.pose
    assert (transform.header.frame_id, transform.child_frame_id) == ('odom', 'base_footprint')
    assert transform.transform.rotation == pose.orientation
    assert all(getattr(transform.transform.translation, axis) == getattr(pose.position, axis)
               for axis in 'xyz')


def test_without_simulated_time_the_stamps_are_the_walls(corner):
    rospy.set_param('/use_sim_time', False)
    start = rospy.Time.now()
    with simulator('__ns:=wall'):
        stamp = Recorder('/wall/odom', Odometry).wait_for(timeout=20.0).header.stamp
        publishers = dict(rosgraph.Master('/test').getSystemState()[0])
    assert start < stamp < rospy.Time.now()
    assert '/wall/sim_turtlebot' in publishers['/wall/odom']
    assert '/wall/sim_turtlebot' not in publishers['/clock']
