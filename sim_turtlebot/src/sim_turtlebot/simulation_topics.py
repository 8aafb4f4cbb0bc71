"""The topics of a simulation: the clock, the transforms, a warning, and those of each robot."""

from functools import partial

import rospy
from odometry_common.publishing import advertise
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from sim_turtlebot.building import new_scanners
from sim_turtlebot.robot_topics import RobotTopics
from sim_turtlebot.scan_topic import ScanTopic

QUEUE_SIZE = 10


class SimulationTopics:
    """Publishes the state of a Simulation, and passes commands on."""

    def __init__(self, simulation, settings):
        """Advertise."""
        self._timeline = simulation.timeline
        self._use_sim_time = settings.use_sim_time
        paced = settings.real_time_factor != 0 and not settings.lockstep_rate
        # A queue keeps a subscriber that has stopped reading from stopping the simulation. It
        # costs much time, so there is none where every microsecond counts.
        queue_size = QUEUE_SIZE if paced else None
        self._clock = advertise('/clock', Clock, queue_size) if self._use_sim_time else None
        self._tf = advertise('/tf', TFMessage, queue_size)
        namespaces = _namespaces(settings.robots)
        self._robots = [RobotTopics(robot, namespace, queue_size) for robot, namespace
                        in zip(simulation.robots, namespaces)]
        self._scans = [
            ScanTopic(scanner, namespace, settings.scan_rate, settings.odom_rate, queue_size)
            for scanner, namespace in zip(new_scanners(simulation, settings), namespaces)]
        self._warning = rospy.Publisher('~warning', String, queue_size=QUEUE_SIZE, latch=True)
        self.warn('')

    def subscribe(self, on_velocity, on_reset_odometry):
        """Listen for on_velocity(robot, linear, angular), an index, m/s, rad/s, and for resets."""
        for index, topics in enumerate(self._robots):
            topics.subscribe(partial(on_velocity, index), partial(on_reset_odometry, index))

    def publish_clock(self):
        """Publish the simulated time, if it rules."""
        if self._clock:
            self._clock.publish(Clock(self._stamp()))

    def publish_robots(self):
        """Publish where the robots are, and what they see."""
        stamp = self._stamp()
        number = self._timeline.odometry_count
        self._tf.publish(TFMessage([topics.publish(stamp, number) for topics in self._robots]))
        for scan in self._scans:
            scan.publish(stamp, number)

    def warn(self, text):
        """Publish a warning; an empty one takes it back."""
        self._warning.publish(text)

    def _stamp(self):
        if self._use_sim_time:
            return rospy.Time(0, self._timeline.now)
        return rospy.Time.now()


def _namespaces(robots):
    return [''] if robots == 1 else [f'robot_{number}/' for number in range(1, robots + 1)]
