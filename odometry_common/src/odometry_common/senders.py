"""Who sends the messages of a topic that only one node should publish."""

import rospy

from odometry_common.subscribing import Subscriber


class SenderWatch:
    """Notices that messages come from two nodes in turn.

    Another node may take the place of the first, as after a restart; the first one is not heard
    again then.
    """

    def __init__(self):
        """Begin before the first message."""
        self._current = None
        self._earlier = set()
        self._noticed = False

    def rivals(self, sender):
        """Take the next message's sender; return the names of two rivals, once, or else None."""
        if self._noticed or sender == self._current:
            return None
        self._noticed = sender in self._earlier
        rivals = sender, self._current
        self._earlier.add(sender)
        self._current = sender
        return rivals if self._noticed else None


def warn_of_two_senders(topic, message_class):
    """Warn, once, when messages of the topic come from two nodes in turn."""
    watch = SenderWatch()

    def check(message):
        rivals = watch.rivals(message._connection_header['callerid'])
        if rivals:
            rospy.logwarn('%s comes from both %s and %s: end one of them', topic, *rivals)

    Subscriber(topic, message_class, check)
