"""TCP ports of this machine."""

import socket


def bind(address, family=socket.AF_INET):
    """Return a socket that has a port and does not listen; raise OSError if another's does.

    A server that sets SO_REUSEADDR, as ROS's and asyncio's do, can listen on the port all the same.

    :param address: host and port, as socket.bind() takes them; port 0 is any
    """
    holder = socket.socket(family)
    holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        holder.bind(address)
    except OSError:
        holder.close()
        raise
    return holder
