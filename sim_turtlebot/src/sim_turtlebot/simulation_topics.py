"""The topics that a simulation publishes: clock, transforms, world, and those of its robots."""

import rospy
from odometry_common.publishing import advertise
from odometry_common.transport import wait_for_slow_subscribers
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from sim_turtlebot.robot_topics import RobotTopics
from sim_turtlebot.world_markers import publish_world

SLOW_SUBSCRIBER_BUDGET = 2.0  # s of wall time, while time is not paced


class SimulationTopics:
    """Publishes the state of a Simulation."""

    def __init__(self, simulation, settings):
        """Advertise."""
        self._timeline = simulation.timeline
        self._use_sim_time = settings.use_sim_time
        # To ROS a time of zero is none: rosbag record would end at a reset. In lockstep the clock
        # comes after the odometry, and zero is where the loops of two runs begin alike.
        self._first_tick = rospy.Time(0, 0 if settings.lockstep else 1)
        if settings.real_time_factor == 0 or settings.lockstep:
            wait_for_slow_subscribers(SLOW_SUBSCRIBER_BUDGET)
        self._clock = advertise('/clock', Clock) if self._use_sim_time else None
        self._tf = advertise('/tf', TFMessage)
        self._robots = [RobotTopics(robot, settings) for robot in simulation.robots]
        fixed = [frame for topics in self._robots for frame in topics.frames.fixed(self._stamp())]
        rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True).publish(fixed)
        publish_world(simulation.world)

    def publish_clock(self):
        """Publish the simulated time, if /use_sim_time is true."""
        if self._clock:
            self._clock.publish(max(self._stamp(), self._first_tick))

    def publish_robots(self):
        """Publish the robots' states, their scans and the transforms."""
        stamp = self._stamp()
        number = self._timeline.odometry_count
        for topics in self._robots:
            topics.publish(stamp, number)
        for topics in self._robots:
            topics.publish_scan(stamp, number)
        if self._tf.get_num_connections():
            self._tf.publish(TFMessage(
                [frame for topics in self._robots for frame in topics.frames.moving(stamp)]))

    def _stamp(self):
        """Return the time of all messages."""
        return (rospy.Time(*divmod(self._timeline.now, 10**9)) if self._use_sim_time
                else rospy.Time.now())
