"""Subscribers whose callbacks run one at a time."""

import threading

import rosgraph
import rospy

from odometry_common.connections import ask
from odometry_common.node import end_node

callback_lock = threading.Lock()  # held while a callback of this node runs


class Subscriber:
    """Calls back with each message of a topic, while no other callback of the node runs.

    rospy itself runs a thread for each connection.
    """

    def __init__(self, topic, message_class, callback, what=None, queue_size=None):
        """Subscribe.

        :param callback: takes a message; if it raises ValueError, a throttled warning says so
        :param what: the messages in words, for the user; None: the topic's name
        :param queue_size: of messages that arrive together, handle only the latest so many;
            None: all
        """
        self._name, self._type = rospy.resolve_name(topic), message_class._type
        self._callback, self._what = callback, what or topic
        self._woken = threading.Event()  # by a message, or at shutdown
        rospy.on_shutdown(self._woken.set)
        rospy.Subscriber(topic, message_class, self._on_message, queue_size=queue_size,
                         tcp_nodelay=True)

    def wait(self):
        """Wait for the first message, or shutdown; log once a second what is missing.

        :return: whether a message has arrived, and the node goes on
        """
        # On a thread, since a suspended master answers late, or never.
        threading.Thread(target=self._log_waiting, daemon=True).start()
        while not (self._woken.wait(timeout=1.0) or rospy.is_shutdown()):
            pass
        return not rospy.core.is_shutdown_requested()

    def _log_waiting(self):
        while not self._woken.wait(timeout=1.0):
            topics = ask(rosgraph.get_master_uri(), 'getPublishedTopics', '') or ()
            other = dict(topics).get(self._name)
            text = f'waiting for {self._what} on {self._name}'
            if other not in (None, self._type) and self._type != rospy.AnyMsg._type:
                text = (f'waiting for {self._what}: '
                        f'{self._name} has the type {other}, not {self._type}')
            if not self._woken.is_set():
                self._log(text)

    @staticmethod
    def _log(text):
        try:
            rospy.loginfo(text)
        except OSError as error:  # the output
            end_node(error)

    def _on_message(self, message):
        try:
            with callback_lock:
                self._callback(message)
        except ValueError as error:
            rospy.logwarn_throttle(1.0, f'{self._what} ignored: {error}')
        except OSError as error:  # the output
            end_node(error)
        else:
            self._woken.set()
