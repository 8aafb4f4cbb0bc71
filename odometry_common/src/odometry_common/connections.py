"""Check that a connection is established; rospy counts it too early."""

import time
import xmlrpc.client

import rospy

ANSWER_TIMEOUT = 5.0  # s; a suspended node does not answer
ANSWER = 2  # its index in (status, message, answer)
SENDS = 'o'
SUBSCRIBER_PERIOD = 0.02  # s of wall time between two checks


class _Transport(xmlrpc.client.Transport):
    """HTTP with a timeout."""

    def make_connection(self, host):
        """Return a connection that gives up after ANSWER_TIMEOUT."""
        connection = super().make_connection(host)
        connection.timeout = ANSWER_TIMEOUT
        return connection


def is_connected(subscriber):
    """Return whether a publisher reports a connection to this rospy.Subscriber."""
    return any(_sends(connection.endpoint_id, subscriber.resolved_name)
               for connection in subscriber.impl.connections)


def has_subscriber_within(publisher, timeout):
    """Return whether a publisher has a subscriber, now or within `timeout` s of wall time.

    :param publisher: rospy.Publisher or ClosingPublisher
    """
    end = time.monotonic() + timeout
    while not (connections := publisher.get_num_connections()) and time.monotonic() < end:
        time.sleep(SUBSCRIBER_PERIOD)
    return connections > 0


def node_at(uri):
    """Return the XML-RPC server at a URI, a node or the master; a call may raise OSError."""
    return xmlrpc.client.ServerProxy(uri, _Transport())


def _sends(uri, topic):
    """Return whether the node with this URI reports a connection to this one."""
    try:
        with node_at(uri) as node:
            connections = node.getBusInfo(rospy.get_name())[ANSWER]
    except (OSError, xmlrpc.client.Error):  # it is shutting down, or has gone
        return False
    return any((listener, direction, name) == (rospy.get_name(), SENDS, topic)
               for _, listener, direction, _, name, *_ in connections)
