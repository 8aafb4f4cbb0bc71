"""Who is connected with whom, as the nodes themselves see it."""

import xmlrpc.client
from typing import NamedTuple

import rosgraph

SENDS, HEARS = 'o', 'i'
CALLER = '/links'


class Link(NamedTuple):
    """A connection of a node."""

    topic: str
    peer: str  # full name of the node that hears, or address of the one that sends
    number: int  # of the connection; never used again


def links(node, direction=SENDS):
    """Return the set of Links over which a node (its full name) sends or hears.

    :raises rosgraph.MasterError, OSError: if there is no such node
    """
    uri = rosgraph.Master(CALLER).lookupNode(node)
    _, _, connections = xmlrpc.client.ServerProxy(uri).getBusInfo(CALLER)
    return {Link(topic, peer, number) for number, peer, way, _, topic, *_ in connections
            if way == direction}
