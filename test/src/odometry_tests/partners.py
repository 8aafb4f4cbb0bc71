"""The partner of a node that runs alone, and its clock."""

import rospy
from rosgraph_msgs.msg import Clock

from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until

QUEUE_SIZE = 5000  # messages; no message of a test is lost
START_TIME = 1000  # s


class Partner:
    """Publishes to a node, and records its answers."""

    def __init__(self, topic, kind, answer_topic, answer_kind):
        self._publisher = rospy.Publisher(topic, kind, queue_size=QUEUE_SIZE, tcp_nodelay=True)
        self.answers = Recorder(answer_topic, answer_kind)

    def say(self, *messages):
        for message in messages:
            self._publisher.publish(message)

    def say_until(self, make, accepts, what):
        """Publish make() again and again until an answer is accepted.

        The first messages to a node that has just started, or the answers to them, may be lost.
        """
        wait_for_subscribers(self._publisher)
        self.answers.clear()

        def accepted():
            self.say(make())
            return self.answers.last is not None and accepts(self.answers.last)

        wait_until(accepted, 5.0, lambda: f'{what}; the last was:\n{self.answers.last}')

    def ask(self, *messages):
        self.answers.clear()
        self.say(*messages)
        return self.answers.wait_for_count(len(messages))


class SteppedClock:
    """The clock of nodes in simulated time: it stands still unless the test advances it."""

    def __init__(self, listeners):
        self.now = rospy.Time(START_TIME)
        self._publisher = rospy.Publisher('/clock', Clock, queue_size=QUEUE_SIZE, latch=True)
        self._publisher.publish(Clock(self.now))
        wait_for_subscribers(self._publisher, listeners)

    def close(self):
        self._publisher.unregister()

    def advance(self, *durations):
        """Let so many seconds pass, one duration after the other."""
        for duration in durations:
            self.now += rospy.Duration.from_sec(duration)
            self._publisher.publish(Clock(self.now))
