"""An XML-RPC server for rospy that comes to an end."""

import rosgraph.xmlrpc


class ClosableServer(rosgraph.xmlrpc.ThreadingXMLRPCServer):
    """A server whose loop ends when its socket is closed.

    rosgraph's own then asks the closed socket again and again: each node that ends keeps a
    processor busy for half a second (https://github.com/ros/ros_comm/issues/2238).
    """

    def service_actions(self):
        """End the loop, which calls this once a turn, if there is no socket any more.

        :raises OSError: to XmlRpcNode, which takes it for the end if it has closed the socket
        """
        if self.socket.fileno() == -1:
            raise OSError('the socket is closed')


def use_closable_server():
    """Have rospy.init_node start this server."""
    rosgraph.xmlrpc.ThreadingXMLRPCServer = ClosableServer
