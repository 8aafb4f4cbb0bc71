"""XML-RPC calls with a timeout, and whether connections exist: rospy counts them too early."""

import http.client
import xmlrpc.client
from xml.parsers.expat import ExpatError

import rospy

ANSWER_TIMEOUT = 5.0  # s; a suspended node does not answer
ANSWER = 2  # its index in (status, message, answer)
SENDS = 'o'
# The errors of a call to a node that is shutting down, or has gone, even if a web server has its
# port now.
NO_ANSWER = OSError, http.client.HTTPException, xmlrpc.client.Error, ExpatError
BAD_URI = ValueError, OverflowError  # the master takes any that begins with http://


class _Transport(xmlrpc.client.Transport):
    """HTTP with a timeout."""

    def make_connection(self, host):
        """Return a connection that gives up after ANSWER_TIMEOUT."""
        connection = super().make_connection(host)
        connection.timeout = ANSWER_TIMEOUT
        return connection


def node_at(uri):
    """Return the XML-RPC server at a URI, a node or the master; a call may raise OSError."""
    return xmlrpc.client.ServerProxy(uri, _Transport())


def ask(uri, call, *arguments):
    """Return what a node or the master answers to a call; None if it does not answer."""
    try:
        with node_at(uri) as node:
            return getattr(node, call)(rospy.get_name(), *arguments)[ANSWER]
    except (*NO_ANSWER, *BAD_URI):
        return None


def is_connected(subscriber):
    """Return whether a publisher reports a connection to this rospy.Subscriber."""
    wanted = rospy.get_name(), SENDS, subscriber.resolved_name
    return any((listener, direction, topic) == wanted
               for connection in subscriber.impl.connections
               for _, listener, direction, _, topic, *_
               in ask(connection.endpoint_id, 'getBusInfo') or ())
