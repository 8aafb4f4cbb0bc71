"""An XML-RPC server for rospy that comes to an end, and tells of connections it cannot take."""

import rosgraph.xmlrpc


class ClosableServer(rosgraph.xmlrpc.ThreadingXMLRPCServer):
    """A server whose loop ends when its socket is closed.

    rosgraph's own then asks the closed socket again and again: each node that ends keeps a
    processor busy for half a second (https://github.com/ros/ros_comm/issues/2238).
    """

    on_failure = None  # is called with the OSError of a connection that is not taken

    def get_request(self):
        """Take a connection; Python's own would keep it waiting and try again at once, for ever."""
        try:
            return super().get_request()
        except OSError as error:
            self.on_failure(error)
            raise

    def service_actions(self):
        """End the loop, which calls this once a turn, if there is no socket any more.

        :raises OSError: to XmlRpcNode, which takes it for the end if it has closed the socket
        """
        if self.socket.fileno() == -1:
            raise OSError('the socket is closed')


def use_closable_server(on_failure):
    """Have rospy.init_node start this server; on_failure(error) is told what it cannot take."""
    ClosableServer.on_failure = staticmethod(on_failure)
    rosgraph.xmlrpc.ThreadingXMLRPCServer = ClosableServer
