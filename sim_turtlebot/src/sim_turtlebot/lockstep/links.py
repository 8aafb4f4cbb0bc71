"""Which connections between nodes are still being made, as the publishers report them."""

from odometry_common.connections import SENDS, ask

ANY_TYPE = '*'  # of a node that takes every type, such as rosbag


def links(publishers, subscribers):
    """Return (topic, publisher, subscriber) for each connection that the master's state asks for.

    :param publishers: pairs of a topic and its nodes
    :param subscribers: likewise
    """
    publishers = dict(publishers)
    return {(topic, publisher, subscriber) for topic, names in subscribers
            for publisher in publishers.get(topic, ()) for subscriber in names}


def missing_links(wanted, addresses):
    """Return those of `wanted` that their publishers do not report: a subscriber lists one early.

    :param wanted: of links()
    :param addresses: by name of the node
    """
    present = {(topic, publisher, subscriber) for publisher in {link[1] for link in wanted}
               for _, subscriber, direction, _, topic, *_
               in ask(addresses[publisher], 'getBusInfo') or ()
               if direction == SENDS}
    return wanted - present


def is_refused(link, addresses):
    """Return whether its nodes have different types for the topic, so that they never connect."""
    topic, publisher, subscriber = link
    types = {dict(ask(addresses[name], call) or ()).get(topic, ANY_TYPE)
             for name, call in ((publisher, 'getPublications'), (subscriber, 'getSubscriptions'))}
    return len(types - {ANY_TYPE}) > 1
