"""What clients of a TurtleBot 2 find beside odometry: frames, the multiplexer's inputs, the IMU.

Two robots in lockstep: what happens when is then the same on every machine.
"""

import math
import sys
from operator import attrgetter

import pytest
import rospy
import tf
from geometry_msgs.msg import Point, Twist
from nav_msgs.msg import Odometry
from odometry_tests.messages import stamp
from odometry_tests.pausing import call
from odometry_tests.robots import twist
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder, wait_for_subscribers
from sensor_msgs.msg import Imu, JointState
from tf2_msgs.msg import TFMessage

VELOCITY, BASE = 'cmd_vel', 'mobile_base/commands/velocity'
TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
WHEELS = 'wheel_left_link', 'wheel_right_link'
DRIFT = 0.02  # rad/s


class Pair:
    """Two robots that get the same commands, and what clients hear of the second one."""

    def __init__(self):
        self._publishers = {topic: [rospy.Publisher(f'/{robot}/{topic}', Twist, queue_size=10)
                                    for robot in ('robot_1', 'robot_2')] for topic in (VELOCITY, BASE, TELEOP, NAVI)}
        self.odometry = Recorder('/robot_2/odom', Odometry)
        self.joints = Recorder('/robot_2/joint_states', JointState)
        self.imu = Recorder('/robot_2/mobile_base/sensors/imu_data', Imu)
        self.tf = Recorder('/tf', TFMessage)
        for publishers in self._publishers.values():
            for publisher in publishers:
                wait_for_subscribers(publisher)

    def restart(self):
        """Begin at time zero: nobody has commanded anything, and nothing older will be heard."""
        recorders = self.odometry, self.joints, self.imu, self.tf
        for recorder in recorders:
            recorder.wait_for_publisher()
            recorder.clear()
        call('reset_simulation')
        for recorder in recorders:
            recorder.wait_for(lambda m: stamp(m) == 0, what='time zero')
            recorder.clear()
        self._number = 0

    def step(self, *speeds, topic=VELOCITY, count=1):
        """Command so many times; return the odometry a period after the last one."""
        for _ in range(count):
            for publisher in self._publishers[topic]:
                publisher.publish(twist(*speeds))
            self._number += 1
            odometry = self.odometry.wait_for(lambda m: m.header.seq == self._number)
        return odometry


@pytest.fixture(scope='module')
def two_robots(master):
    rospy.set_param('/use_sim_time', True)
    with simulator('_robots:=2', '_real_time_factor:=0', '_lockstep:=true', '_odometry_source:=encoder',
                   '_gyro_noise:=0.01', f'_gyro_drift:={DRIFT}'):
        yield Pair()
    rospy.set_param('/use_sim_time', False)


@pytest.fixture
def robots(two_robots):
    two_robots.restart()
    return two_robots


def test_a_late_subscriber_gets_the_fixed_frames(robots):
    """In one message for all robots, each frame with one parent, and none of them on /tf."""
    fixed = Recorder('/tf_static', TFMessage).wait_for().transforms
    tree = {frame.child_frame_id: frame.header.frame_id for frame in fixed}
    assert len(tree) == len(fixed)
    for name in 'robot_1/', 'robot_2/':
        assert (tree[f'{name}base_link'], tree[f'{name}gyro_link']) == (f'{name}base_footprint', f'{name}base_link')
    odometry = robots.step(0.0)
    assert (odometry.header.frame_id, odometry.child_frame_id) == ('robot_2/odom', 'robot_2/base_footprint')
    moving = {frame.child_frame_id for frame in robots.tf.wait_for().transforms}
    assert moving == {f'robot_{number}/{link}' for number in (1, 2) for link in ('base_footprint', *WHEELS)}


def test_tf_repeats_the_odometry_and_the_joint_states(robots):
    odometry = robots.step(0.3, 0.5, count=30)
    now = stamp(odometry)
    joints = robots.joints.wait_for(lambda m: stamp(m) == now)
    frames = robots.tf.wait_for(lambda m: stamp(m) == now).transforms
    rotations = {frame.child_frame_id: frame.transform.rotation for frame in frames}
    base, pose = next(frame for frame in frames if frame.child_frame_id == 'robot_2/base_footprint'), odometry.pose.pose
    assert (base.header.frame_id, base.transform.rotation) == ('robot_2/odom', pose.orientation)
    assert Point(*attrgetter('x', 'y', 'z')(base.transform.translation)) == pose.position
    assert joints.name == ['wheel_left_joint', 'wheel_right_joint']
    assert abs(joints.position[1] - joints.position[0]) > 1.0
    assert joints.velocity == pytest.approx((6.93, 10.21), abs=0.5)  # rad/s
    for link, angle in zip(WHEELS, joints.position):
        seen = rotations[f'robot_2/{link}']
        expected = tf.transformations.euler_matrix(-math.pi / 2, 0.0, angle, 'rxyz')
        error = tf.transformations.quaternion_matrix([seen.x, seen.y, seen.z, seen.w]) - expected
        assert abs(error).max() < 1e-9


def test_the_imu_has_the_heading_of_the_odometry(robots):
    """It drifts, also at rest, by the same noise; the place stays where it is."""
    odometry = robots.step(0.0, count=200)
    imu = robots.imu.wait_for(lambda m: stamp(m) == stamp(odometry))
    assert imu.header.frame_id == 'robot_2/gyro_link'
    assert imu.orientation == odometry.pose.pose.orientation
    assert imu.angular_velocity.z == odometry.twist.twist.angular.z
    yaw = 2 * math.atan2(imu.orientation.z, imu.orientation.w)
    assert 1e-6 < abs(yaw - 10 * DRIFT) < 0.15
    assert (odometry.pose.pose.position.x, odometry.pose.pose.position.y) == (0, 0)
    for covariance in imu.orientation_covariance, imu.angular_velocity_covariance:
        assert covariance[::4] == (sys.float_info.max, sys.float_info.max, 0.005)
    assert imu.linear_acceleration_covariance[0] == -1, 'the acceleration counts as measured'


def test_what_goes_to_the_base_directly_is_obeyed_whatever_the_multiplexer_keeps_out(robots):
    robots.step(0.0, topic=TELEOP)
    assert robots.step(0.2, topic=NAVI, count=6).twist.twist.linear.x == 0.0
    assert robots.step(0.2, topic=BASE, count=6).twist.twist.linear.x == pytest.approx(0.2, abs=0.02)
