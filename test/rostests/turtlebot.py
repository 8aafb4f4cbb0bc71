#!/usr/bin/env python3
"""What clients of a TurtleBot 2 find beside odometry: frames, the multiplexer's inputs, the IMU."""

import math
import sys
import unittest

import tf
from odometry_tests.messages import stamp
from odometry_tests.pausing import call
from odometry_tests.robots import BASE, NAVI, TELEOP, Robot
from odometry_tests.rostests import run_rostest
from odometry_tests.waiting import Recorder
from sensor_msgs.msg import Imu
from tf2_msgs.msg import TFMessage

WHEELS = 'wheel_left_link', 'wheel_right_link'
DRIFT = 0.02  # rad/s


class TurtlebotTest(unittest.TestCase):
    """Given two robots, each is a TurtleBot 2 in its namespace."""

    @classmethod
    def setUpClass(cls):
        cls.robots = cls.robot, _ = Robot('robot_2/'), Robot('robot_1/')
        cls.imu = Recorder('/robot_2/mobile_base/sensors/imu_data', Imu)
        cls.tf = Recorder('/tf', TFMessage)
        for robot in cls.robots:
            robot.wait_until_ready()

    def setUp(self):
        """Begin at time zero: nobody has commanded anything, and nothing older will be heard."""
        recorders = self.robot.odometry, self.robot.joints, self.imu, self.tf
        for recorder in recorders:
            recorder.wait_for_publisher()
            recorder.clear()
        call('reset_simulation')
        for recorder in recorders:
            recorder.wait_for(lambda m: stamp(m) == 0, what='time zero')
            recorder.clear()
        self.number = 0

    def step(self, command):
        """Command both robots; return the odometry of the second one a period later."""
        for robot in self.robots:
            command(robot)
        self.number += 1
        return self.robot.odometry.wait_for(lambda m: m.header.seq == self.number)

    def test_a_late_subscriber_gets_the_fixed_frames(self):
        """In one message for all robots, each frame with one parent, and none of them on /tf."""
        fixed = Recorder('/tf_static', TFMessage).wait_for().transforms
        tree = {frame.child_frame_id: frame.header.frame_id for frame in fixed}
        self.assertEqual(len(tree), len(fixed))
        for name in 'robot_1/', 'robot_2/':
            self.assertEqual(tree[f'{name}base_link'], f'{name}base_footprint')
            self.assertEqual(tree[f'{name}gyro_link'], f'{name}base_link')
        odometry = self.step(lambda robot: robot.drive(0.0))
        self.assertEqual((odometry.header.frame_id, odometry.child_frame_id),
                         ('robot_2/odom', 'robot_2/base_footprint'))
        moving = {frame.child_frame_id for frame in self.tf.wait_for().transforms}
        self.assertEqual(moving, {f'robot_{number}/{link}' for number in (1, 2)
                                  for link in ('base_footprint', *WHEELS)})

    def test_wheels_turn_in_tf_as_in_joint_states(self):
        for _ in range(30):
            now = stamp(self.step(lambda robot: robot.drive(0.3, 0.5)))
        joints = self.robot.joints.wait_for(lambda m: stamp(m) == now)
        frames = self.tf.wait_for(lambda m: stamp(m) == now).transforms
        rotations = {frame.child_frame_id: frame.transform.rotation for frame in frames}
        self.assertEqual(joints.name, ['wheel_left_joint', 'wheel_right_joint'])
        self.assertNotAlmostEqual(*joints.position, delta=1.0)
        for speed, expected in zip(joints.velocity, (6.93, 10.21)):  # rad/s
            self.assertAlmostEqual(speed, expected, delta=0.5)
        for link, angle in zip(WHEELS, joints.position):
            seen = rotations[f'robot_2/{link}']
            expected = tf.transformations.euler_matrix(-math.pi / 2, 0.0, angle, 'rxyz')
            error = tf.transformations.quaternion_matrix([seen.x, seen.y, seen.z, seen.w]) - expected
            self.assertLess(abs(error).max(), 1e-9)

    def test_the_imu_has_the_heading_of_the_odometry(self):
        """It drifts, also at rest, by the same noise; the place stays where it is."""
        for _ in range(200):
            odometry = self.step(lambda robot: robot.drive(0.0))
        imu = self.imu.wait_for(lambda m: stamp(m) == stamp(odometry))
        self.assertEqual(imu.header.frame_id, 'robot_2/gyro_link')
        self.assertEqual(imu.orientation, odometry.pose.pose.orientation)
        self.assertEqual(imu.angular_velocity.z, odometry.twist.twist.angular.z)
        yaw = 2 * math.atan2(imu.orientation.z, imu.orientation.w)
        self.assertAlmostEqual(yaw, 10 * DRIFT, delta=0.15)
        self.assertNotAlmostEqual(yaw, 10 * DRIFT, places=6)
        self.assertEqual((odometry.pose.pose.position.x, odometry.pose.pose.position.y), (0, 0))
        for covariance in imu.orientation_covariance, imu.angular_velocity_covariance:
            self.assertEqual(covariance[::4], (sys.float_info.max, sys.float_info.max, 0.005))

    def test_what_goes_to_the_base_directly_is_obeyed_whatever_the_multiplexer_keeps_out(self):
        self.step(lambda robot: robot.drive(0.0, topic=TELEOP))
        for _ in range(6):
            moving = self.step(lambda robot: robot.drive(0.2, topic=NAVI)).twist.twist.linear.x
        self.assertEqual(moving, 0.0)
        for _ in range(6):
            moving = self.step(lambda robot: robot.drive(0.2, topic=BASE)).twist.twist.linear.x
        self.assertAlmostEqual(moving, 0.2, delta=0.02)


if __name__ == '__main__':
    run_rostest('turtlebot', TurtlebotTest, disable_rostime=True)
