"""What clients of a TurtleBot 2 find beside odometry: frames, the multiplexer's inputs, the IMU.

Two robots in lockstep, step by step: what happens when is then the same on every machine.
"""

import math
import sys
from operator import attrgetter

import numpy
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


class Robot:
    """The second of two robots, as clients command and hear it."""

    def __init__(self):
        self._publishers = {topic: rospy.Publisher(f'/robot_2/{topic}', Twist, queue_size=10)
                            for topic in (VELOCITY, BASE, TELEOP, NAVI)}
        self.odometry = Recorder('/robot_2/odom', Odometry)
        self.joints = Recorder('/robot_2/joint_states', JointState)
        self.imu = Recorder('/robot_2/mobile_base/sensors/imu_data', Imu)
        self.tf = Recorder('/tf', TFMessage)
        for publisher in self._publishers.values():
            wait_for_subscribers(publisher)
        for recorder in self.odometry, self.joints, self.imu, self.tf:
            recorder.wait_for_publisher()
        step(1)  # time zero

    def step(self, *speeds, topic=VELOCITY, count=1):
        """Command so many times; return the odometry a period after the last one."""
        for _ in range(count):
            self._publishers[topic].publish(twist(*speeds))
            answer, = step(1)
        return self.odometry.wait_for(lambda m: stamp(m) == float(answer.message))


@pytest.fixture
def robot(simulated_time):
    with simulator_in_step('_robots:=2', '_paused:=true', '_odometry_source:=encoder',
                           '_gyro_noise:=0.01', '_gyro_drift:=0.02'):
        yield Robot()


def test_tf_has_the_odometry_the_joint_states_and_for_a_late_subscriber_the_fixed_frames(robot):
    """These in one message for all robots, each frame with one parent, and none of them on /tf."""
    odometry = robot.step(0.3, 0.5, count=30)
    now, pose = stamp(odometry), odometry.pose.pose
    joints = robot.joints.wait_for(lambda m: stamp(m) == now)
    frames = robot.tf.wait_for(lambda m: stamp(m) == now).transforms
    moving = {frame.child_frame_id: frame.transform for frame in frames}
    assert moving.keys() == {f'robot_{number}/{link}' for number in (1, 2) for link in ('base_footprint', *WHEELS)}
    assert (odometry.header.frame_id, odometry.child_frame_id) == ('robot_2/odom', 'robot_2/base_footprint')
    base = moving['robot_2/base_footprint']
    assert (Point(*attrgetter('x', 'y', 'z')(base.translation)), base.rotation) == (pose.position, pose.orientation)
    assert joints.name == ['wheel_left_joint', 'wheel_right_joint']
    assert joints.velocity == pytest.approx((6.93, 10.21), abs=0.5)  # rad/s
    for link, angle in zip(WHEELS, joints.position):
        seen = moving[f'robot_2/{link}'].rotation
        expected = tf.transformations.quaternion_from_euler(-math.pi / 2, 0.0, angle, 'rxyz')
        assert abs(numpy.dot([seen.x, seen.y, seen.z, seen.w], expected)) == pytest.approx(1.0, abs=1e-15)
    fixed = Recorder('/tf_static', TFMessage).wait_for().transforms
    tree = {frame.child_frame_id: frame.header.frame_id for frame in fixed}
    assert len(tree) == len(fixed)
    for name in 'robot_1/', 'robot_2/':
        assert (tree[f'{name}base_link'], tree[f'{name}gyro_link']) == (f'{name}base_footprint', f'{name}base_link')


def test_the_imu_has_the_heading_of_the_odometry(robot):
    """It drifts, also at rest, by the same noise; the place stays where it is."""
    odometry = robot.step(0.0, count=200)
    imu = robot.imu.wait_for(lambda m: stamp(m) == stamp(odometry))
    assert imu.header.frame_id == 'robot_2/gyro_link'
    assert imu.orientation == odometry.pose.pose.orientation
    assert imu.angular_velocity.z == odometry.twist.twist.angular.z
    assert abs(imu.orientation.z) > 0.01
    assert (odometry.pose.pose.position.x, odometry.pose.pose.position.y) == (0, 0)
    for covariance in imu.orientation_covariance, imu.angular_velocity_covariance:
        assert covariance[::4] == (sys.float_info.max, sys.float_info.max, 0.005)
    assert imu.linear_acceleration_covariance[0] == -1, 'the acceleration counts as measured'


def test_what_goes_to_the_base_directly_is_obeyed_whatever_the_multiplexer_keeps_out(robot):
    robot.step(0.0, topic=TELEOP)
    assert robot.step(0.2, topic=NAVI, count=6).twist.twist.linear.x == 0.0
    assert robot.step(0.2, topic=BASE, count=6).twist.twist.linear.x == pytest.approx(0.2, abs=0.02)
