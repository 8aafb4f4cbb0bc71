#!/usr/bin/env python3
"""The controller turns the robot to its target by the shorter way, and to a new target."""

import math
import sys
import threading
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64
from tf.transformations import euler_from_quaternion

TIMEOUT = 60.0  # s of wall time


class RotateTest(unittest.TestCase):
    """Given the robot at heading 0, and a controller whose target is 90 degrees."""

    def setUp(self):
        """Follow the true heading."""
        self.headings = []  # degrees
        self.changed = threading.Condition()
        rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_truth)

    def on_truth(self, message):
        """Keep each heading."""
        rotation = message.pose.pose.orientation
        yaw = euler_from_quaternion([rotation.x, rotation.y, rotation.z, rotation.w])[2]
        with self.changed:
            self.headings.append(math.degrees(yaw))
            self.changed.notify()

    def way_to(self, target):
        """Return the headings (degrees) until the robot is within a degree of a target."""
        with self.changed:
            arrived = self.changed.wait_for(
                lambda: self.headings and abs(self.headings[-1] - target) < 1.0, TIMEOUT)
            self.assertTrue(arrived, f'not at {target} degrees, but {self.headings[-1:]}')
            way, self.headings = self.headings, []
        return way

    def test_it_turns_by_the_shorter_way_also_to_a_new_target(self):
        """From 90 to -170 degrees it turns left through 180, and never sees 0."""
        self.assertGreater(min(self.way_to(90.0)), -1.0)
        target = rospy.Publisher('rotate_robot/target', Float64, queue_size=1, latch=True)
        target.publish(-170.0)
        way = self.way_to(-170.0)
        self.assertGreater(min(map(abs, way)), 80.0, way)


if __name__ == '__main__':
    rospy.init_node('rotate_test')
    rostest.rosrun('odometry_tests', 'rotate', RotateTest, sys.argv)
