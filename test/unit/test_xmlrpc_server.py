"""The XML-RPC server of a node ends when rospy closes it, and keeps no processor busy."""

import threading

from odometry_common.xmlrpc_server import use_closable_server
from odometry_tests.waiting import wait_until
from rosgraph.xmlrpc import XmlRpcNode


def test_a_closed_server_ends_its_thread():
    """Closed as rospy does it at shutdown."""
    use_closable_server(lambda error: None)
    server = XmlRpcNode()
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    wait_until(lambda: server.uri, 10.0, 'a server that listens')
    server.shutdown('test')
    thread.join(10.0)
    assert not thread.is_alive()
