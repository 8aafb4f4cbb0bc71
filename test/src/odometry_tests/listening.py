"""On which addresses processes listen."""

import contextlib
import os
import socket

from odometry_tests.linux import descendants
from odometry_tests.waiting import wait_until

LISTENING = '0A'  # a state of TCP sockets in /proc/net/tcp
LOOK_PERIOD = 0.2  # s
LOOPBACK = {'127.0.0.1', '::1'}


def listening_addresses(pid):
    """Return the IP addresses on which a process and its descendants listen for TCP connections."""
    inodes = {inode for one in [pid, *descendants(pid)] for inode in _sockets(one)}
    addresses = set()
    for table, family in (('tcp', socket.AF_INET), ('tcp6', socket.AF_INET6)):
        with open(f'/proc/net/{table}') as rows:
            for row in list(rows)[1:]:
                fields = row.split()
                if fields[3] == LISTENING and fields[9] in inodes:
                    addresses.add(_readable(fields[1].split(':')[0], family))
    return addresses


def listened_on(process, timeout):
    """Return the IP addresses on which a Process has listened before its end."""
    seen = set()

    def has_ended():
        seen.update(listening_addresses(process.pid))
        return not process.running

    wait_until(has_ended, timeout, lambda: f'the end; it printed:\n{process.output}', LOOK_PERIOD)
    return seen


def assert_loopback_only(pid):
    """Assert that a process and its descendants listen, and nobody but this machine reaches them."""
    addresses = listening_addresses(pid)
    assert addresses and addresses <= LOOPBACK, addresses


def _sockets(pid):
    """Return the inodes of a process's sockets."""
    links = []
    with contextlib.suppress(OSError):  # it has ended meanwhile
        for entry in os.scandir(f'/proc/{pid}/fd'):
            with contextlib.suppress(OSError):
                links.append(os.readlink(entry.path))
    return [link[len('socket:['):-1] for link in links if link.startswith('socket:[')]


def _readable(hexadecimal, family):
    """Return an address of /proc/net in the usual form: its words are in host byte order."""
    words = [bytes.fromhex(hexadecimal[start:start + 8])[::-1]
             for start in range(0, len(hexadecimal), 8)]
    return socket.inet_ntop(family, b''.join(words))
