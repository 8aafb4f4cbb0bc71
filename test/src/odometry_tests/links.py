"""The connections of nodes, as the nodes report them."""

import xmlrpc.client
from typing import NamedTuple

import rosgraph
from odometry_common.connections import ANSWER, SENDS

RECEIVES = 'i'
CALLER = '/links'


class Link(NamedTuple):
    """A connection of a node."""

    topic: str
    peer: str  # full name of the subscriber, or address of the publisher
    number: int  # of the connection; never used again


def links(node, direction=SENDS, master_uri=None):
    """Return the set of Links over which a node (its full name) publishes, or subscribes.

    :raises rosgraph.MasterError, OSError: if there is no such node
    """
    connections = _node(node, master_uri).getBusInfo(CALLER)[ANSWER]
    return {Link(topic, peer, number) for number, peer, way, _, topic, *_ in connections
            if way == direction}


def has_listener(topic):
    """Return whether a topic's publisher is connected to a subscriber."""
    publishers = dict(rosgraph.Master(CALLER).getSystemState()[0]).get(topic, [])
    return any(link.topic == topic for node in publishers for link in links(node))


def pid_of(node, master_uri=None):
    """Return the process id of a node (its full name), from itself."""
    return _node(node, master_uri).getPid(CALLER)[ANSWER]


def _node(name, master_uri=None):
    return xmlrpc.client.ServerProxy(rosgraph.Master(CALLER, master_uri).lookupNode(name))
