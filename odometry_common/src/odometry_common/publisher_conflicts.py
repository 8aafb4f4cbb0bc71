"""Warnings about several nodes that publish a topic that only one should publish."""

import threading
import time

import rosgraph
import rospy

LOOK_PERIOD = 1.0  # s of wall time
LONGEST_PERIOD = 30.0  # s of wall time; on a busy machine one answer may take long
SHARE = 500  # the master of a hundred robots has long answers: ask it for 1/500 of the time at most


class ConflictWatch:
    """Decides which conflicts are news."""

    def __init__(self):
        """Begin before the first look."""
        self._seen = set()
        self._reported = set()

    def news(self, publishers):
        """Take the names of all publishers now; return those to report, or nothing.

        A publisher seen only once may be shutting down. Each new one is reported with all others.
        """
        lasting = self._seen & publishers
        self._seen = publishers
        if len(lasting) < 2 or lasting <= self._reported:
            return []
        self._reported |= lasting
        return sorted(lasting)


def warn_of_conflicts(topic, find_publishers=None):
    """Warn, until shutdown, whenever another node begins to publish a topic that has a publisher.

    :param find_publishers: returns the set of their names; None: ask the ROS master
    """
    name = rospy.resolve_name(topic)
    arguments = name, find_publishers or (lambda: _registered_publishers(name))
    threading.Thread(target=_watch, args=arguments, daemon=True).start()


def period_after(duration):
    """Return how long (s) to wait for the next look after one that took `duration` seconds."""
    return min(LONGEST_PERIOD, max(LOOK_PERIOD, SHARE * duration))


def _watch(topic, find_publishers):
    watch, period = ConflictWatch(), LOOK_PERIOD
    while not rospy.is_shutdown():
        time.sleep(period)
        start = time.monotonic()
        conflict = watch.news(find_publishers())
        if conflict:
            rospy.logwarn(f'{topic} is published by {" and ".join(conflict)}: stop all but one')
        period = period_after(time.monotonic() - start)


def _registered_publishers(topic):
    try:
        topics, _, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    except (OSError, rosgraph.MasterException):
        return set()
    return set(dict(topics).get(topic, ()))
