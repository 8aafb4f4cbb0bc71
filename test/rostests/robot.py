#!/usr/bin/env python3
"""The simulated robot: its odometry, limits, watchdog and reset."""

import sys
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import Empty

TIMEOUT = 60.0  # s of wall time


class RobotTest(unittest.TestCase):
    """Given the robot, and commands that this test publishes at each odometry."""

    def setUp(self):
        """Follow odometry and truth; command what self.command is."""
        self.command, self.odometry, self.truth = None, [], []
        self.changed = threading.Condition()
        self.publisher = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.subscribers = [rospy.Subscriber('base_pose_ground_truth', Odometry, self.on_message, self.truth),
                            rospy.Subscriber('odom', Odometry, self.on_message, self.odometry)]

    def tearDown(self):
        """Leave a robot that nobody commands."""
        for subscriber in self.subscribers:
            subscriber.unregister()

    def on_message(self, message, messages):
        """Keep a message; command the robot once for each odometry."""
        if messages is self.odometry and self.command:
            self.publisher.publish(self.command)
        with self.changed:
            messages.append(message)
            self.changed.notify()

    def wait_for(self, condition, what):
        """Wait until a condition holds for the latest odometry."""
        with self.changed:
            self.assertTrue(self.changed.wait_for(
                lambda: self.odometry and condition(self.odometry[-1]), TIMEOUT), f'no {what}: {self.odometry[-1:]}')

    def drive(self, linear):
        """Command a linear speed (m/s) from now on."""
        self.command = Twist()
        self.command.linear.x = linear

    def test_odometry_comes_at_20_hz_and_is_the_truth(self):
        """While the robot drives: every stamp 50 ms after the last, every pose that of ground truth."""
        self.drive(0.3)
        self.wait_for(lambda _: len(self.odometry) > 40, 'two seconds of driving')
        with self.changed:
            truth = {message.header.stamp: message.pose.pose for message in self.truth}
            steps = [after.header.stamp - before.header.stamp
                     for before, after in zip(self.odometry, self.odometry[1:])]
            both = [(truth[message.header.stamp], message.pose.pose) for message in self.odometry
                    if message.header.stamp in truth]
        self.assertEqual({step.to_nsec() for step in steps}, {50000000})
        self.assertGreater(len(both), 20)
        self.assertTrue(all(true == seen for true, seen in both), both)

    def test_it_drives_no_faster_than_a_turtlebot_2_and_stops_without_commands(self):
        """At most 0.7 m/s; 0.6 s after the last command it brakes, within half a second."""
        self.drive(5.0)
        self.wait_for(lambda message: message.twist.twist.linear.x > 0.69, 'top speed')
        self.wait_for(lambda _: len(self.odometry) > 60, 'three seconds at top speed')
        self.command, last = None, self.odometry[-1].header.stamp
        self.wait_for(lambda message: message.twist.twist == Twist(), 'rest')
        self.assertLess(max(message.twist.twist.linear.x for message in self.odometry), 0.71)
        self.assertTrue(0.6 < (self.odometry[-1].header.stamp - last).to_sec() < 1.2, (last, self.odometry[-1]))

    def test_a_reset_starts_again(self):
        """At time zero and at the origin, after a drive."""
        self.drive(0.5)
        self.wait_for(lambda message: message.pose.pose.position.x > 0.5, 'drive')
        self.command = None
        rospy.ServiceProxy('sim_turtlebot/reset_simulation', Empty)()
        self.wait_for(lambda message: message.header.stamp.to_sec() < 1.0, 'new start')
        first = next(message for message in self.odometry[::-1] if message.header.stamp.to_sec() <= 0.05)
        self.assertAlmostEqual(first.pose.pose.position.x, 0.0, delta=0.01)


if __name__ == '__main__':
    rospy.init_node('robot_test')
    rostest.rosrun('odometry_tests', 'robot', RobotTest, sys.argv)
