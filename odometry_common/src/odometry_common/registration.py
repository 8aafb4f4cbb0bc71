"""How rospy learns who publishes a topic."""

from rospy.impl.registration import RegManager


def remember_publishers():
    """Have rospy.init_node make nodes that lose no publisher to news in the wrong order.

    The master answers a new subscriber with the publishers of its topic, and tells it of those that
    come later. If the first of them is told before the answer has been read, rospy takes the answer,
    which is older, for the latest, and never connects the two.
    """
    RegManager.publisher_update = _add_update


def _add_update(manager, topic, addresses):
    """Queue these publishers of a topic together with those for which there was no time yet.

    One that has gone meanwhile does no harm: rospy's attempt to connect to it fails.
    """
    with manager.cond:
        waiting = [address for name, others in manager.updates if name == topic
                   for address in others]
        manager.updates.append((topic, list(dict.fromkeys([*waiting, *addresses]))))
        manager.cond.notify_all()
