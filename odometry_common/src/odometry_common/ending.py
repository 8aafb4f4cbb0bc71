"""How a node ends at once."""

import contextlib
import threading

import rospy
from rospy.impl.registration import get_registration_listeners

# s of the main thread: it hears a signal that comes just before a wait only after it
LONGEST_WAIT = 0.5


def spin():
    """Wait for shutdown, and notice it at once, while rospy.spin() looks for it twice a second."""
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    while not (rospy.core.is_shutdown_requested() or ended.wait(LONGEST_WAIT)):
        pass


def end_without_delay():
    """Spare an initialised node's end the half second that rospy's registering thread may sleep.

    At shutdown rospy waits for this thread. It wakes it too early, before the node counts as shut
    down, so that the thread goes back to sleep.
    """
    for manager in get_registration_listeners().listeners:
        rospy.core.add_shutdown_hook(lambda _reason, cond=manager.cond: _wake(cond))


@contextlib.contextmanager
def quiet_at_shutdown():
    """Swallow what rospy raises if it closes a topic, at shutdown, while it is being published."""
    try:
        yield
    except rospy.ROSException:
        if not rospy.core.is_shutdown_requested():
            raise


def _wake(condition):
    with condition:
        condition.notify_all()
