"""The connections of nodes, as the nodes report them."""

import xmlrpc.client

import rosgraph
from odometry_common.connections import ANSWER, SENDS

RECEIVES = 'i'
CALLER = '/links'


def connected_topics(node, direction=SENDS, master_uri=None):
    """Return the topics on which a node (its full name) sends to others, or receives.

    :raises rosgraph.MasterError, OSError: if there is no such node
    """
    connections = _node(node, master_uri).getBusInfo(CALLER)[ANSWER]
    return {topic for _, _, way, _, topic, *_ in connections if way == direction}


def has_listener(topic):
    publishers = dict(rosgraph.Master(CALLER).getSystemState()[0]).get(topic, [])
    return any(topic in connected_topics(node) for node in publishers)


def pid_of(node, master_uri=None):
    return _node(node, master_uri).getPid(CALLER)[ANSWER]


def _node(name, master_uri=None):
    return xmlrpc.client.ServerProxy(rosgraph.Master(CALLER, master_uri).lookupNode(name))
