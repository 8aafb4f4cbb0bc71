"""Subscribers that do not read."""

import contextlib
import socket
import xmlrpc.client
from io import BytesIO

import rosgraph
from odometry_tests.links import ANSWER
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until
from rosgraph.network import read_ros_handshake_header, write_ros_handshake_header

NAME = '/stuck'
SMALL_SEGMENT = 536  # bytes; a publisher then sets aside little memory for what is not read yet


@contextlib.contextmanager
def stuck_subscriber(topic):
    """Subscribe to a topic (its full name), once it is published, and never read a message."""
    wait_until(lambda: publisher_of(topic), TIMEOUT, f'a publisher of {topic}')
    with connected(publisher_of(topic), topic) as connection:
        write_ros_handshake_header(connection, {
            'callerid': NAME, 'topic': topic, 'type': '*', 'md5sum': '*', 'tcp_nodelay': '1'})
        header = read_ros_handshake_header(connection, BytesIO(), 1)
        assert 'error' not in header, header
        yield


@contextlib.contextmanager
def connected(node, topic):
    """Yield a socket that is connected to the port at which a node serves a topic."""
    with xmlrpc.client.ServerProxy(rosgraph.Master(NAME).lookupNode(node)) as api:
        _, host, port = api.requestTopic(NAME, topic, [['TCPROS']])[ANSWER]
    with socket.socket() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1)  # the system's smallest
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_MAXSEG, SMALL_SEGMENT)
        connection.settimeout(TIMEOUT * PATIENCE)
        connection.connect((host, port))
        yield connection


def publisher_of(topic):
    """Return the name of a node that publishes a topic, or None."""
    publishers = dict(rosgraph.Master(NAME).getSystemState()[0]).get(topic)
    return publishers and publishers[0]
