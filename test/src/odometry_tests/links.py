"""The connections of nodes, as the nodes report them."""

import rosgraph
from odometry_common.connections import SENDS, ask


def has_listener(topic):
    connections = [connection for node in dict(rosgraph.Master('/links').getSystemState()[0]).get(topic, [])
                   for connection in _ask(node, 'getBusInfo')]
    return any((direction, connected) == (SENDS, topic) for _, _, direction, _, connected, *_ in connections)


def pid_of(node, master_uri=None):
    return _ask(node, 'getPid', master_uri)


def _ask(node, call, master_uri=None):
    return ask(rosgraph.Master('/links', master_uri).lookupNode(node), call)
