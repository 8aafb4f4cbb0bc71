#!/usr/bin/env python3
"""What main.py prints is the robot's true heading."""

import math
import subprocess
import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from tf.transformations import euler_from_quaternion

TIMEOUT = 60.0  # s of wall time


def yaw_of(message):
    """Return the heading (rad) in an odometry message."""
    rotation = message.pose.pose.orientation
    return euler_from_quaternion([rotation.x, rotation.y, rotation.z, rotation.w])[2]


class HeadingTest(unittest.TestCase):
    """Given a robot that has turned, and main.py."""

    def setUp(self):
        """Turn the robot by about 90 degrees, and let it come to rest."""
        self.publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.command_until(lambda truth: yaw_of(truth) > math.pi / 2, 1.0)
        self.yaw = yaw_of(self.command_until(lambda truth: truth.twist.twist == Twist(), 0.0))

    def command_until(self, condition, speed):
        """Command an angular speed (rad/s) until a condition holds for the true pose; return that pose."""
        command, end = Twist(), rospy.get_time() + TIMEOUT
        command.angular.z = speed
        while rospy.get_time() < end:
            truth = rospy.wait_for_message('base_pose_ground_truth', Odometry, TIMEOUT)
            if condition(truth):
                return truth
            self.publisher.publish(command)
        return self.fail(f'{speed:g} rad/s commanded for {TIMEOUT:g} s; the last pose was:\n{truth}')

    def test_it_prints_the_yaw_and_the_quaternion_of_it(self):
        """The yaw at each odometry, and the quaternion [x y z w] each second."""
        command = ['timeout', str(TIMEOUT), 'rosrun', 'rotate_robot', 'main.py']
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as printer:
            lines = [printer.stdout.readline() for _ in range(30)]
            printer.terminate()
        quaternions = [line for line in lines if line.startswith('[')]
        self.assertTrue(quaternions, lines)
        for line in lines:
            if line in quaternions:
                x, y, z, w = map(float, line.strip('[] \n').split())
                yaw = euler_from_quaternion([x, y, z, w])[2]
            else:
                yaw = float(line)
            self.assertAlmostEqual(yaw, self.yaw, delta=1e-6)


if __name__ == '__main__':
    rospy.init_node('heading_test')
    rostest.rosrun('odometry_tests', 'heading', HeadingTest, sys.argv)
