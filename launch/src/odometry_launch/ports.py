"""TCP ports of this machine for servers that are yet to start."""

import contextlib
import os
import socket
from urllib.parse import urlparse

from odometry_common.ports import bind
from rosgraph.rosenv import DEFAULT_MASTER_PORT

HOST = 'localhost'
PAGE_PORT = 8080  # the usual one
NEXT_PORTS = 100  # are tried after the first


class HeldPort:
    """A port that nobody else is given until it is closed.

    Two sockets that do not listen may have the same port: a name that belongs to one process at
    a time tells their owners apart. Linux forgets it with its socket.
    """

    def __init__(self, number, is_first_choice=True):
        """Take a port, or any for 0; raise OSError if it is another's."""
        self.is_first_choice = is_first_choice
        with contextlib.ExitStack() as stack:
            self.number = stack.enter_context(bind((HOST, number))).getsockname()[1]
            name = stack.enter_context(socket.socket(socket.AF_UNIX))
            name.bind(f'\0odometry-port-{self.number}')
            self.close = stack.pop_all().close


def master_port():
    """Hold the usual port, so that rostopic finds the demo, or else another one."""
    usual = _usual_port()
    with contextlib.suppress(OSError):
        return HeldPort(usual)
    while True:
        with contextlib.suppress(OSError):
            return HeldPort(0, is_first_choice=False)


def page_port(first):
    """Hold the first port that is free, from a number on; raise OSError if there is none."""
    for number in range(first, first + NEXT_PORTS):
        try:
            return HeldPort(number, number == first)
        except OSError as error:
            refusal = error
    raise refusal


def _usual_port():
    """Return the port in ROS_MASTER_URI if that makes sense."""
    try:
        return urlparse(os.environ.get('ROS_MASTER_URI', '')).port or DEFAULT_MASTER_PORT
    except ValueError:
        return DEFAULT_MASTER_PORT
