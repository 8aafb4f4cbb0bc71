"""Warn of a second node on a topic that only one should publish."""

import threading

import rosgraph
import rospy

from odometry_common.connections import ask

CONFLICT_PERIOD = 1.0  # s of wall time between two checks


def warn_of_conflicts(topic, advice='stop all but one'):
    """Ask the master every second, and warn once if more than one node publishes a topic."""
    threading.Thread(target=_watch, args=[rospy.resolve_name(topic), advice], daemon=True).start()


def _watch(topic, advice):
    ended, before = threading.Event(), set()
    rospy.on_shutdown(ended.set)
    while not ended.wait(CONFLICT_PERIOD):
        state = ask(rosgraph.get_master_uri(), 'getSystemState')
        publishers = set(dict(state[0]).get(topic, ())) if state else set()
        lasting = before & publishers  # a publisher seen only once may be shutting down
        if len(lasting) > 1 and len(living := sorted(filter(_answers, lasting))) > 1:
            rospy.logwarn(f'{topic} is published by {" and ".join(living)}: {advice}')
            return
        before = publishers


def _answers(name):
    """Return whether a node lives: one that was killed stays registered."""
    uri = ask(rosgraph.get_master_uri(), 'lookupNode', name)
    return uri and ask(uri, 'getPid') is not None
