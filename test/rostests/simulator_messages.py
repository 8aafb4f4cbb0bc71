#!/usr/bin/env python3
"""What the simulator publishes, by the contract."""

import math
import unittest

import rosgraph
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from odometry_tests.robots import Robot, place
from odometry_tests.rostests import run_rostest
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from rosgraph_msgs.msg import Log
from tf2_msgs.msg import TFMessage

START = 1.0, -2.0, 1.5  # m, m, rad; where the robot in the corner starts
TUTORIAL_VARIANCES = [1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001]


class SimulatorMessagesTest(unittest.TestCase):
    """Given commands, the simulator's messages are those of a TurtleBot 2."""

    @classmethod
    def setUpClass(cls):
        cls.tf = Recorder('/tf', TFMessage)
        cls.alone, cls.corner = Robot('alone/'), Robot('corner/')
        for robot in cls.alone, cls.corner:
            robot.wait_until_ready()

    def step(self, count, *speeds):
        """Command the robot so many times; return the odometry that follows each command."""
        seen = [self.alone.odometry.last]
        for _ in range(count):
            self.alone.drive(*speeds)
            seen.append(self.alone.odometry.wait_for(
                lambda m: m.header.seq > seen[-1].header.seq))
        return seen[1:]

    def test_odometry_has_the_fields_of_the_tutorial(self):
        message, _ = self.corner.restart()
        self.assertEqual(message.header.frame_id, 'odom')
        self.assertEqual(message.child_frame_id, 'base_footprint')
        self.assertEqual(list(message.pose.covariance[::7]), TUTORIAL_VARIANCES)
        self.assertEqual(sum(map(abs, message.pose.covariance)), sum(TUTORIAL_VARIANCES))
        self.assertEqual(set(message.twist.covariance), {0.0})
        self.assertEqual(message.twist.twist, Twist())

    def test_it_starts_where_it_is_told_and_odometry_starts_at_zero(self):
        """Ground truth is in the world, odometry from the start on."""
        message, truth = self.corner.restart()
        self.assertEqual((truth.header.frame_id, truth.child_frame_id), ('world', 'base_footprint'))
        self.assertEqual(place(truth), START)
        self.assertEqual(place(message), (0.0, 0.0, 0.0))
        self.corner.drive(0.5)
        self.corner.odometry.wait_for(lambda m: place(m)[0] >= 0.5, what='half a metre')
        self.assertEqual(place(self.corner.odometry.last)[1:], (0.0, 0.0))

    def test_a_command_that_is_not_finite_is_refused_and_stops_the_robot(self):
        log = Recorder('/rosout', Log)
        log.wait_for_publisher()
        self.corner.restart()
        self.corner.drive(0.3, 0.5)
        self.corner.truth.wait_until_moving()
        self.corner.drive(math.nan)
        self.corner.truth.wait_until_resting()
        log.wait_for(lambda m: m.level == Log.WARN and 'is not finite' in m.msg)

    def test_tf_repeats_the_odometry(self):
        """From odom to base_footprint, with the same stamp; the wheels are behind it."""
        message = self.step(3, 0.2, 0.5)[-1]
        found = self.tf.wait_for(lambda m: sender(m) == '/alone/sim_turtlebot' and
                                 m.transforms[0].header.stamp == message.header.stamp)
        transform, pose = found.transforms[0], message.pose.pose
        self.assertEqual(transform.header.frame_id, 'odom')
        self.assertEqual(transform.child_frame_id, 'base_footprint')
        self.assertEqual(transform.transform.rotation, pose.orientation)
        for axis in 'xyz':
            self.assertEqual(getattr(transform.transform.translation, axis),
                             getattr(pose.position, axis))

    def test_without_simulated_time_the_stamps_are_the_walls(self):
        rospy.set_param('/use_sim_time', False)
        self.addCleanup(rospy.set_param, '/use_sim_time', True)
        start = rospy.Time.now()
        with simulator(env={'ROS_NAMESPACE': 'wall'}):
            stamp = Recorder('/wall/odom', Odometry).wait_for(timeout=20.0).header.stamp
            publishers, _, _ = rosgraph.Master('/test').getSystemState()
        self.assertTrue(start < stamp < rospy.Time.now(), stamp)
        self.assertIn('/wall/sim_turtlebot', dict(publishers)['/wall/odom'])
        self.assertNotIn('/wall/sim_turtlebot', dict(publishers)['/clock'])


def sender(message):
    return message._connection_header['callerid']


if __name__ == '__main__':
    run_rostest('simulator_messages', SimulatorMessagesTest, disable_rostime=True)
