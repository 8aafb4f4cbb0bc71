"""How rospy registers a node, and learns who publishes a topic."""

import time

from rospy.impl.registration import RegManager

REGISTRATION_TIME = 0.1  # s; after as long rospy looks again itself
LOOK_PERIOD = 0.001  # s


def mend_registration():
    """Have rospy.init_node make nodes that start sooner and lose no publisher.

    rospy asks ten times a second whether the node is registered, which takes a few milliseconds:
    the first answer is always no.

    The master answers a new subscriber with the publishers of its topic, and tells it of those that
    come later. If the first of them is told before the answer has been read, rospy takes the answer,
    which is older, for the latest, and never connects the two.
    """
    RegManager.is_registered = _is_registered_soon
    RegManager.publisher_update = _add_update


def _is_registered_soon(manager):
    """Return whether the node is registered, or is so before rospy would ask again."""
    end = time.monotonic() + REGISTRATION_TIME
    while not manager.registered and time.monotonic() < end:
        time.sleep(LOOK_PERIOD)
    return manager.registered


def _add_update(manager, topic, addresses):
    """Queue these publishers of a topic together with those for which there was no time yet.

    One that has gone meanwhile does no harm: rospy's attempt to connect to it fails.
    """
    with manager.cond:
        waiting = [address for name, others in manager.updates if name == topic
                   for address in others]
        manager.updates.append((topic, list(dict.fromkeys([*waiting, *addresses]))))
        manager.cond.notify_all()
