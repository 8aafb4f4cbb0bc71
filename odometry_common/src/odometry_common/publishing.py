"""Publishers that send each message at once, and none after their final message."""

import threading
import warnings

import rospy

from odometry_common.transport import flush

CLOSE_TIMEOUT = 0.3  # s, for subscribers that are behind


def advertise(topic, message_class):
    """Return a rospy.Publisher without a queue.

    publish() writes the message to every subscriber's socket and returns; without a thread in
    between, the latency is a third lower. In a node that run_node() runs, a subscriber that does
    not read loses messages and does not block the publisher.
    """
    with warnings.catch_warnings():
        # rospy warns of a publisher without a queue.
        warnings.simplefilter('ignore', SyntaxWarning)
        return rospy.Publisher(topic, message_class, tcp_nodelay=True, queue_size=None)


class ClosingPublisher:
    """Publishes until the node shuts down, and then its final message, if it has one.

    publish() writes to the subscribers before it returns, so the process may exit right after the
    final message, and no older message follows it.
    """

    def __init__(self, topic, message_class, final_message=None):
        self._publisher = advertise(topic, message_class)
        self._final_message = final_message
        self._lock = threading.Lock()
        self._closed = False
        rospy.on_shutdown(self._close)

    def get_num_connections(self):
        """Return the number of connected subscribers, as a rospy.Publisher does."""
        return self._publisher.get_num_connections()

    def publish(self, message):
        """Send a message, unless the node is shutting down."""
        with self._lock:
            if not self._closed:
                self._publisher.publish(message)

    def _close(self):
        with self._lock:
            self._closed = True
            if self._final_message is not None:
                self._publisher.publish(self._final_message)
        flush(self._publisher, CLOSE_TIMEOUT)
