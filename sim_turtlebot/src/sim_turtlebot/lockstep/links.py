"""Connections that nodes fail to make, by the addresses (URIs) of the nodes."""

from odometry_common.connections import ask

ANY_TYPE = '*'  # of a node that takes every type, such as rosbag


def is_refused(topic, publisher, subscriber):
    """Return whether two nodes have different types for a topic, and so never connect."""
    ends = (publisher, 'getPublications'), (subscriber, 'getSubscriptions')
    types = {dict(ask(address, call) or ()).get(topic, ANY_TYPE) for address, call in ends}
    return len(types - {ANY_TYPE}) > 1


def repeat_update(topic, subscriber, *publishers):
    """Send the publishers of a topic to a subscriber again, as the master sent them.

    rospy loses one that overtakes the master's answer to the subscriber; our own nodes do not, as
    odometry_common.rospy_fixes says.
    """
    ask(subscriber, 'publisherUpdate', topic, [*filter(None, publishers)])
