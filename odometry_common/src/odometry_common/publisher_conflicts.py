"""Warn of a second node on a topic that only one should publish."""

import http.client
import threading
import xmlrpc.client

import rosgraph
import rospy

from odometry_common.connections import node_at

CONFLICT_PERIOD = 1.0  # s of wall time between two checks


def warn_of_conflicts(topic):
    """Ask the master every second, and warn once if more than one node publishes a topic."""
    threading.Thread(target=_watch, args=[rospy.resolve_name(topic)], daemon=True).start()


def _watch(topic):
    ended, before = threading.Event(), set()
    rospy.on_shutdown(ended.set)
    while not ended.wait(CONFLICT_PERIOD):
        publishers = _publishers(topic)
        lasting = before & publishers  # a publisher seen only once may be shutting down
        if len(lasting) > 1:
            rospy.logwarn(f'{topic} is published by {" and ".join(sorted(lasting))}: stop all but one')
            return
        before = publishers


def _publishers(topic):
    try:
        with node_at(rosgraph.get_master_uri()) as master:
            _, _, (publishers, _, _) = master.getSystemState(rospy.get_name())
    except (OSError, http.client.HTTPException, xmlrpc.client.Error):
        return set()
    return set(dict(publishers).get(topic, ()))
