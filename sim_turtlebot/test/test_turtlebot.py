"""What clients of a TurtleBot 2 find beside odometry: frames, the multiplexer's inputs, the IMU."""

import math
import sys

import pytest
import rospy
import tf
from odometry_tests.messages import stamp
from odometry_tests.pausing import call, pause
from odometry_tests.robots import BASE, NAVI, TELEOP, Robot
from odometry_tests.tutorial import simulator_in_step
from odometry_tests.waiting import Recorder
from sensor_msgs.msg import Imu
from tf2_msgs.msg import TFMessage

WHEELS = 'wheel_left_link', 'wheel_right_link'
DRIFT = 0.02  # rad/s


class Pair:
    """Two robots in lockstep: what happens when is then the same on every machine."""

    def __init__(self):
        self.robots = self.robot, _ = Robot('robot_2/'), Robot('robot_1/')
        self.imu = Recorder('/robot_2/mobile_base/sensors/imu_data', Imu)
        self.tf = Recorder('/tf', TFMessage)
        for robot in self.robots:
            robot.wait_until_ready()

    def begin(self):
        """Begin at time zero: nobody has commanded anything, and nothing older will be heard."""
        recorders = self.robot.odometry, self.robot.joints, self.imu, self.tf
        pause(*recorders)
        for recorder in recorders:
            recorder.clear()
        call('reset_simulation')
        call('unpause_physics')
        self.number = 0

    def step(self, command):
        """Command both robots; return the odometry of the second one a period later."""
        for robot in self.robots:
            command(robot)
        self.number += 1
        return self.robot.odometry.wait_for(lambda m: m.header.seq == self.number)


@pytest.fixture(scope='module')
def running(master):
    rospy.set_param('/use_sim_time', True)
    with simulator_in_step('_robots:=2', '_real_time_factor:=0', '_odometry_source:=encoder',
                           '_gyro_noise:=0.01', f'_gyro_drift:={DRIFT}'):
        yield Pair()


@pytest.fixture
def pair(running):
    running.begin()
    return running


def test_late_subscribers_get_the_fixed_frames(pair):
    """In one message for all robots, each frame with one parent, and none of them on /tf."""
    fixed = Recorder('/tf_static', TFMessage).wait_for().transforms
    tree = {frame.child_frame_id: frame.header.frame_id for frame in fixed}
    assert len(tree) == len(fixed)
    for name in 'robot_1/', 'robot_2/':
        assert tree[f'{name}base_link'] == f'{name}base_footprint'
        assert tree[f'{name}gyro_link'] == f'{name}base_link'
    pair.step(lambda robot: robot.drive(0.0))
    moving = {frame.child_frame_id for frame in pair.tf.wait_for().transforms}
    assert moving == {f'robot_{number}/{link}' for number in (1, 2)
                      for link in ('base_footprint', *WHEELS)}


def test_wheels_turn_in_tf_as_in_joint_states(pair):
    """At the same stamp by the same angle, about the axle."""
    for _ in range(30):
        now = stamp(pair.step(lambda robot: robot.drive(0.3, 0.5)))
    joints = pair.robot.joints.wait_for(lambda m: stamp(m) == now)
    frames = pair.tf.wait_for(lambda m: stamp(m) == now).transforms
    rotations = {frame.child_frame_id: frame.transform.rotation for frame in frames}
    assert joints.name == ['wheel_left_joint', 'wheel_right_joint']
    assert abs(joints.position[0] - joints.position[1]) > 1.0
    assert joints.velocity == pytest.approx((6.93, 10.21), abs=0.5)  # rad/s
    for link, angle in zip(WHEELS, joints.position):
        seen = rotations[f'robot_2/{link}']
        expected = tf.transformations.euler_matrix(-math.pi / 2, 0.0, angle, 'rxyz')
        error = tf.transformations.quaternion_matrix([seen.x, seen.y, seen.z, seen.w]) - expected
        assert abs(error).max() < 1e-9


def test_the_imu_has_the_heading_of_the_odometry(pair):
    """It drifts, also at rest, by the same noise; the place stays where it is."""
    for _ in range(200):
        odometry = pair.step(lambda robot: robot.drive(0.0))
    imu = pair.imu.wait_for(lambda m: stamp(m) == stamp(odometry))
    assert imu.header.frame_id == 'robot_2/gyro_link'
    assert imu.orientation == odometry.pose.pose.orientation
    assert imu.angular_velocity.z == odometry.twist.twist.angular.z
    yaw = 2 * math.atan2(imu.orientation.z, imu.orientation.w)
    assert 1e-6 < abs(yaw - 10 * DRIFT) < 0.15
    assert (odometry.pose.pose.position.x, odometry.pose.pose.position.y) == (0, 0)
    for covariance in imu.orientation_covariance, imu.angular_velocity_covariance:
        assert covariance[::4] == (sys.float_info.max, sys.float_info.max, 0.005)


def test_what_goes_to_the_base_directly_is_obeyed_whatever_the_multiplexer_keeps_out(pair):
    pair.step(lambda robot: robot.drive(0.0, topic=TELEOP))
    for _ in range(6):
        moving = pair.step(lambda robot: robot.drive(0.2, topic=NAVI)).twist.twist.linear.x
    assert moving == 0.0
    for _ in range(6):
        moving = pair.step(lambda robot: robot.drive(0.2, topic=BASE)).twist.twist.linear.x
    assert moving == pytest.approx(0.2, abs=0.02)
