"""The topics of a simulation: the clock, the transforms, a warning, and those of each robot."""

from functools import partial

import rospy
from odometry_common.publishing import advertise
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from sim_turtlebot.robot_topics import RobotTopics

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
        self._robots = [RobotTopics(robot, namespace, queue_size) for robot, namespace
                        in zip(simulation.robots, namespaces(settings.robots))]
        self._warning = rospy.Publisher('~warning', String, queue_size=QUEUE_SIZE, latch=True)

    def subscribe(self, *callbacks):
        """Listen as RobotTopics.subscribe() does; each callback takes the robot's index first."""
        for index, topics in enumerate(self._robots):
            topics.subscribe(*(partial(callback, index) for callback in callbacks))

    def publish_clock(self):
        """Publish the simulated time, if it rules."""
        if self._clock:
            self._clock.publish(Clock(self._stamp()))

    def publish_robots(self):
        """Publish where the robots are."""
        stamp = self._stamp()
        number = self._timeline.odometry_count
        self._tf.publish(TFMessage([topics.publish(stamp, number) for topics in self._robots]))

    def warn(self, text):
        """Publish what there is to warn of; empty: nothing."""
        self._warning.publish(text)

    def _stamp(self):
        if self._use_sim_time:
            return rospy.Time(0, self._timeline.now)
        return rospy.Time.now()


def namespaces(robots):
    """Return the namespace of each of so many robots, '' or one that ends in a slash."""
    return [''] if robots == 1 else [f'robot_{number}/' for number in range(1, robots + 1)]
