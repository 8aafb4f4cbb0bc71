"""Waits that end with an event or, within a bound, with a word about what was seen."""

import os
import threading
import time

import rospy
from odometry_common.connections import is_connected

# Every bound on a wait is multiplied by this: a bound ends a test that hangs, and no verdict
# about the robot may hang on it.
PATIENCE = float(os.environ.get('ODOMETRY_TEST_PATIENCE', '4'))
TIMEOUT = 20.0  # s
POLL_PERIOD = 0.02  # s; lockstep would wait for a process that polls faster

open_recorders = []


def wait_until(condition, timeout, what, period=POLL_PERIOD):
    """Return the first true value of condition().

    :param timeout: s of wall time, multiplied by PATIENCE
    :param what: what is waited for, in words; a function if it has to be worded at the end
    :param period: s between two looks
    :raises AssertionError: if there is none in time
    """
    bound = timeout * PATIENCE
    began, end = 0.0, time.monotonic() + bound
    while not (value := condition()):
        if began >= end:  # a look may take long
            words = what() if callable(what) else what
            raise AssertionError(f'not within {bound:g} s: {words}')
        began = time.monotonic()
        time.sleep(period)
    return value


class Recorder:
    """Every message on a topic since the recorder was made."""

    def __init__(self, topic, message_class):
        self._topic = topic
        self._changed = threading.Condition()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, message_class, self._on_message,
                                            tcp_nodelay=True)
        open_recorders.append(self)

    def close(self):
        self._subscriber.unregister()

    @property
    def messages(self):
        with self._changed:
            return list(self._messages)

    @property
    def last(self):
        with self._changed:
            return self._messages[-1] if self._messages else None

    def clear(self):
        with self._changed:
            self._messages.clear()

    def wait_for_publisher(self):
        """Return once a publisher is connected: this recorder misses no later message."""
        wait_until(lambda: is_connected(self._subscriber), TIMEOUT, f'a publisher of {self._topic}')

    def wait_for(self, accepts=lambda message: True, timeout=TIMEOUT, what='a message'):
        """Return the first message, also one that has come already, that is accepted."""
        with self._changed:
            message = self._changed.wait_for(
                lambda: next(filter(accepts, self._messages), None), timeout * PATIENCE)
        assert message is not None, (
            f'not within {timeout * PATIENCE:g} s on {self._topic}: {what}; the last of '
            f'{len(self._messages)} messages was:\n{self.last}')
        return message

    def wait_for_count(self, count, timeout=TIMEOUT):
        with self._changed:
            self._changed.wait_for(lambda: len(self._messages) >= count, timeout * PATIENCE)
            seen = list(self._messages)
        assert len(seen) >= count, f'{len(seen)} of {count} messages on {self._topic}'
        return seen[:count]

    def _on_message(self, message):
        with self._changed:
            self._messages.append(message)
            self._changed.notify_all()


def wait_for_subscribers(publisher, count=1, timeout=TIMEOUT):
    """Return once so many other nodes subscribe to the publisher: what it sends then arrives.

    A recorder of an earlier test, in this process, may be quicker than they are.
    """
    wait_until(lambda: sum(connection.endpoint_id != rospy.get_name()
                           for connection in publisher.impl.connections) >= count,
               timeout, f'{count} subscriber(s) of {publisher.name}')
