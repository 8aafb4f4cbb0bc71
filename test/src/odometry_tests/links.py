"""The connections of nodes, as the nodes report them."""

import xmlrpc.client

import rosgraph
from odometry_common.connections import ANSWER, SENDS

CALLER = '/links'


def has_listener(topic):
    publishers = dict(rosgraph.Master(CALLER).getSystemState()[0]).get(topic, [])
    connections = [connection for node in publishers for connection in _node(node).getBusInfo(CALLER)[ANSWER]]
    return any((direction, connected) == (SENDS, topic) for _, _, direction, _, connected, *_ in connections)


def pid_of(node, master_uri=None):
    return _node(node, master_uri).getPid(CALLER)[ANSWER]


def _node(name, master_uri=None):
    return xmlrpc.client.ServerProxy(rosgraph.Master(CALLER, master_uri).lookupNode(name))
