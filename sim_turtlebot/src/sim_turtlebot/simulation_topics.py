"""The topics of a simulation: the clock, the transforms, a warning, and those of each robot."""

from copy import copy
from functools import partial

import rospy
from odometry_common.publishing import advertise
from odometry_common.transport import wait_for_subscribers
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from sim_turtlebot.building import new_scanners
from sim_turtlebot.robot_topics import RobotTopics
from sim_turtlebot.scan_topic import ScanTopic

PATIENCE = 2.0  # s of wall time, for a subscriber that is behind while time is not paced


class SimulationTopics:
    """Publishes the state of a Simulation, and passes commands on."""

    def __init__(self, simulation, settings):
        """Advertise."""
        self._timeline = simulation.timeline
        self._time = rospy.Time()
        self._clock_message = Clock()
        self._use_sim_time = settings.use_sim_time
        if settings.real_time_factor == 0 or settings.lockstep:
            wait_for_subscribers(PATIENCE)
        self._clock = advertise('/clock', Clock) if self._use_sim_time else None
        self._tf = advertise('/tf', TFMessage)
        names = namespaces(settings.robots)
        self._robots = [RobotTopics(robot, namespace) for robot, namespace
                        in zip(simulation.robots, names)]
        self._scans = [
            ScanTopic(scanner, namespace, settings.scan_rate, settings.odom_rate)
            for scanner, namespace in zip(new_scanners(simulation, settings), names)]
        self._tf_static = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        self._tf_static.publish(TFMessage(
            [frame for topics in self._robots for frame in topics.fixed_frames(copy(self._stamp()))]))
        self._warning = rospy.Publisher('~warning', String, queue_size=10, latch=True)

    def subscribe(self, *callbacks):
        """Listen as RobotTopics.subscribe() does, but for the robot's index after the sender."""
        for index, topics in enumerate(self._robots):
            topics.subscribe(*(partial(callback, index) for callback in callbacks))

    def publish_clock(self):
        """Publish the simulated time, if it rules."""
        if self._clock:
            self._clock_message.clock = self._stamp()
            self._clock.publish(self._clock_message)

    def publish_robots(self):
        """Publish where the robots are, and what they see."""
        stamp = self._stamp()
        number = self._timeline.odometry_count
        for topics in self._robots:
            topics.publish(stamp, number)
        for scan in self._scans:
            scan.publish(stamp, number)
        if self._tf.get_num_connections():
            self._tf.publish(self._transforms(stamp))

    def warn(self, text):
        """Publish what there is to warn of; empty: nothing."""
        self._warning.publish(text)

    def _transforms(self, stamp):
        frames = [topics.base_frame(stamp) for topics in self._robots]
        for topics in self._robots:
            frames += topics.wheel_frames(stamp)
        return TFMessage(frames)

    def _stamp(self):
        """Return the time of all messages; in simulated time a rospy.Time that goes on with it."""
        if not self._use_sim_time:
            return rospy.Time.now()
        self._time.secs, self._time.nsecs = divmod(self._timeline.now, 10**9)
        return self._time


def namespaces(robots):
    """Return the namespace of each of so many robots, '' or one that ends in a slash."""
    return [''] if robots == 1 else [f'robot_{number}/' for number in range(1, robots + 1)]
