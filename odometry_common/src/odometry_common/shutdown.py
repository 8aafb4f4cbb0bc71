"""How a node waits for shutdown."""

import threading

import rospy

# s of the main thread: Python handles a signal that arrives just before a wait only after it
LONGEST_WAIT = 0.5


def spin():
    """Return at once at shutdown, for which rospy.spin() looks only twice a second."""
    ended = threading.Event()
    rospy.on_shutdown(ended.set)
    while not (rospy.core.is_shutdown_requested() or ended.wait(LONGEST_WAIT)):
        pass
