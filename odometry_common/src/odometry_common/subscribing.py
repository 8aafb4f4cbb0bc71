"""Subscribers whose callbacks run one at a time."""

import threading

import rospy

one_at_a_time = threading.Lock()  # is held while a callback of this node runs


class Subscriber:
    """Calls back with each message of a topic, while no other callback of the node runs.

    rospy has a thread for each connection.
    """

    def __init__(self, topic, message_class, callback, what=None):
        """Subscribe.

        :param callback: takes a message; one over which it raises ValueError is ignored, with a
            throttled warning
        :param what: the messages in words, for the user; None: the topic's name
        """
        self._topic, self._callback, self._what = topic, callback, what or topic
        self._received = threading.Event()
        rospy.on_shutdown(self._received.set)
        self._subscriber = rospy.Subscriber(topic, message_class, self._on_message, tcp_nodelay=True)

    def publishers(self):
        """Return the set of the names of the nodes that it is connected to."""
        return {connection.callerid_pub for connection in self._subscriber.impl.connections}

    def wait(self):
        """Return at the first message or at shutdown; log once a second that it waits."""
        while not (self._received.wait(timeout=1.0) or rospy.is_shutdown()):
            rospy.loginfo('waiting for %s on %s', self._what, rospy.resolve_name(self._topic))

    def _on_message(self, message):
        try:
            with one_at_a_time:
                self._callback(message)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'{self._what} ignored: {error}')
        else:
            self._received.set()
