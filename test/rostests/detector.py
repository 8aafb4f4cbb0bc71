#!/usr/bin/env python3
"""The detector adds up the robot's moves, and starts again at a reset."""

import queue
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Odometry
from std_msgs.msg import Empty, Float64

TIMEOUT = 30.0  # s of wall time
PERIOD = rospy.Duration(0.05)
SIDE = [0.1 * step for step in range(1, 11)]  # m
SQUARE = ([(way, 0.0) for way in SIDE] + [(1.0, way) for way in SIDE]
          + [(1.0 - way, 1.0) for way in SIDE] + [(0.0, 1.0 - way) for way in SIDE])


class DetectorTest(unittest.TestCase):
    """Given a detector, and odometry that this test publishes."""

    def setUp(self):
        """Connect to the detector; it answers each odometry message with the distance."""
        self.distances = queue.Queue()
        rospy.Subscriber('moved_distance', Float64, self.distances.put)
        self.odometry = rospy.Publisher('odom', Odometry, queue_size=10)
        self.reset = rospy.Publisher('moved_distance/reset', Empty, queue_size=1)
        self.message = Odometry()
        self.message.header.stamp = rospy.Time(1)
        self.message.pose.pose.orientation.w = 1.0
        self.distance_at(0.0, 0.0)

    def distance_at(self, x, y):
        """Report a position (m) until the detector answers; return the distance (m)."""
        position, end = self.message.pose.pose.position, rospy.get_time() + TIMEOUT
        position.x, position.y = x, y
        while rospy.get_time() < end:
            self.message.header.stamp += PERIOD
            self.odometry.publish(self.message)
            try:
                return self.distances.get(timeout=0.5).data
            except queue.Empty:
                continue  # not connected yet
        return self.fail(f'no moved_distance at ({x}, {y})')

    def test_a_square_counts_its_whole_way_and_a_reset_starts_again(self):
        """Then it stays where it is: at rest no distance is added."""
        for x, y in SQUARE:
            self.distance_at(x, y)
        # On a slow machine the first of these answer earlier messages.
        distance, *others = [self.distance_at(0.0, 0.0) for _ in range(10)][5:]
        self.assertAlmostEqual(distance, 4.0, places=9)
        self.assertEqual(others, [distance] * 4)
        self.reset.publish()
        end = rospy.get_time() + TIMEOUT
        while distance != 0.0 and rospy.get_time() < end:
            distance = self.distance_at(0.0, 0.0)
        self.assertEqual(distance, 0.0)
        while distance == 0.0 and rospy.get_time() < end:
            distance = self.distance_at(0.1, 0.0)
        self.assertAlmostEqual(distance, 0.1, places=9)


if __name__ == '__main__':
    rospy.init_node('detector_test')
    rostest.rosrun('odometry_tests', 'detector', DetectorTest, sys.argv)
