"""What clients of a TurtleBot 2 find beside odometry: frames, the multiplexer's inputs, the IMU.

Two robots in lockstep, step by step: what happens when is then the same on every machine.
"""

import math
import sys
from operator import attrgetter

import pytest
import rospy
import tf
from geometry_msgs.msg import Point, Twist
from lockstep_runs import step
from nav_msgs.msg import Odometry
from odometry_tests.messages import stamp
from odometry_tests.robots import twist
from odometry_tests.tutorial import simulator_in_step
from odometry_tests.waiting import Recorder, wait_for_subscribers
from sensor_msgs.msg import Imu, JointState
from tf2_msgs.msg import TFMessage

VELOCITY, BASE = 'cmd_vel', 'mobile_base/commands/velocity'
TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
WHEELS = 'wheel_left_link', 'wheel_right_link'


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
        for recorder in self.odometry, self.joints, self.imu, self.tf:
            recorder.wait_for_publisher()
        step(1)  # time zero

    def step(self, *speeds, topic=VELOCITY, count=1):
        """Command so many times; return the odometry a period after the last one."""
        for _ in range(count):
            for publisher in self._publishers[topic]:
                publisher.publish(twist(*speeds))
            answer, = step(1)
        return self.odometry.wait_for(lambda m: stamp(m) == float(answer.message))


@pytest.fixture
def robots(simulated_time):
    with simulator_in_step('_robots:=2', '_paused:=true', '_odometry_source:=encoder',
                           '_gyro_noise:=0.01', '_gyro_drift:=0.02'):
        yield Pair()


def test_tf_has_the_odometry_the_joint_states_and_for_a_late_subscriber_the_fixed_frames(robots):
    """These in one message for all robots, each frame with one parent, and none of them on /tf."""
    odometry = robots.step(0.3, 0.5, count=30)
    now = stamp(odometry)
    joints = robots.joints.wait_for(lambda m: stamp(m) == now)
    frames = robots.tf.wait_for(lambda m: stamp(m) == now).transforms
    rotations = {frame.child_frame_id: frame.transform.rotation for frame in frames}
    assert rotations.keys() == {f'robot_{number}/{link}' for number in (1, 2) for link in ('base_footprint', *WHEELS)}
    assert (odometry.header.frame_id, odometry.child_frame_id) == ('robot_2/odom', 'robot_2/base_footprint')
    fixed = Recorder('/tf_static', TFMessage).wait_for().transforms
    tree = {frame.child_frame_id: frame.header.frame_id for frame in fixed}
    assert len(tree) == len(fixed)
    for name in 'robot_1/', 'robot_2/':
        assert (tree[f'{name}base_link'], tree[f'{name}gyro_link']) == (f'{name}base_footprint', f'{name}base_link')
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
    assert abs(imu.orientation.z) > 0.01
    assert (odometry.pose.pose.position.x, odometry.pose.pose.position.y) == (0, 0)
    for covariance in imu.orientation_covariance, imu.angular_velocity_covariance:
        assert covariance[::4] == (sys.float_info.max, sys.float_info.max, 0.005)
    assert imu.linear_acceleration_covariance[0] == -1, 'the acceleration counts as measured'


def test_what_goes_to_the_base_directly_is_obeyed_whatever_the_multiplexer_keeps_out(robots):
    robots.step(0.0, topic=TELEOP)
    assert robots.step(0.2, topic=NAVI, count=6).twist.twist.linear.x == 0.0
    assert robots.step(0.2, topic=BASE, count=6).twist.twist.linear.x == pytest.approx(0.2, abs=0.02)
