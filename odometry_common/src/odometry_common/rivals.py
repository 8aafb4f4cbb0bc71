"""Who else publishes a topic that only one node should publish, as the ROS master knows it."""

import threading
import time

import rosgraph
import rospy

LOOK_PERIOD = 1.0  # s of wall time
LONGEST_PERIOD = 30.0  # s of wall time; on a busy machine one answer may take long
SHARE = 500  # the master of a hundred robots has long answers: ask it for 1/500 of the time at most


class RivalWatch:
    """Decides which other publishers are news."""

    def __init__(self):
        """Begin before the first look."""
        self._seen = set()
        self._told = set()

    def news(self, others):
        """Take the names of who else publishes now; return those to tell of, or nothing.

        Who is seen only once may be about to end. All of them are told of again when a new one
        has come.
        """
        lasting = self._seen & others
        self._seen = others
        if lasting <= self._told:
            return []
        self._told |= lasting
        return sorted(lasting)


def warn_of_rivals(topic):
    """Warn, from now until shutdown, of each other node that publishes the topic."""
    threading.Thread(target=_watch, args=[rospy.resolve_name(topic)], daemon=True).start()


def period_after(duration):
    """Return how long (s) to wait for the next look after one that took `duration` seconds."""
    return min(LONGEST_PERIOD, max(LOOK_PERIOD, SHARE * duration))


def _watch(topic):
    watch, period = RivalWatch(), LOOK_PERIOD
    while not rospy.is_shutdown():
        time.sleep(period)
        start = time.monotonic()
        rivals = watch.news(_other_publishers(topic))
        if rivals:
            rospy.logwarn(f'{topic} is also published by {", ".join(rivals)}: the robot obeys '
                          'each in turn; end all but one')
        period = period_after(time.monotonic() - start)


def _other_publishers(topic):
    try:
        topics, _, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    except (OSError, rosgraph.MasterException):
        return set()
    return set(dict(topics).get(topic, ())) - {rospy.get_name()}
