"""TCP ports for servers that have not started yet."""

import contextlib
import os
import socket
from urllib.parse import urlparse

from rosgraph.rosenv import DEFAULT_MASTER_PORT

HOST = 'localhost'
NEXT_PORTS, LAST_PORT = 100, 2**16 - 1  # to try after the first


class HeldPort:
    """A port, or any for 0, that no other demo or sweep takes until close().

    OSError: another process has it. Sockets that do not listen can share a port; a name in Linux's
    abstract namespace, which belongs to one process and ends with it, keeps them apart.
    """

    def __init__(self, number):
        with contextlib.ExitStack() as stack:
            port = stack.enter_context(socket.socket())
            # ROS's and asyncio's servers set this, too, and so can listen on the port.
            port.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            port.bind((HOST, number))
            self.number = port.getsockname()[1]
            name = stack.enter_context(socket.socket(socket.AF_UNIX))
            name.bind(f'\0odometry-port-{self.number}')
            self.close = stack.pop_all().close


def next_port(first):
    """Return the first HeldPort from a number on, or any for 0; raise OSError if none is free."""
    last = min(first + NEXT_PORTS, LAST_PORT)
    numbers = range(first, last + 1) if first else [0] * NEXT_PORTS
    for number in numbers:
        try:
            return HeldPort(number)
        except OSError as error:
            refusal = error
    raise refusal


def usual_master_port():
    """Return the port in ROS_MASTER_URI, which rostopic uses, or ROS's default."""
    with contextlib.suppress(ValueError):
        return urlparse(os.environ.get('ROS_MASTER_URI', '')).port or DEFAULT_MASTER_PORT
    return DEFAULT_MASTER_PORT


def listens(port):
    """Return whether a process on this machine listens on a port."""
    with socket.socket() as connection:
        return connection.connect_ex((HOST, port)) == 0
