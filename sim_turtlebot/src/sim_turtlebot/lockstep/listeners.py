"""Find the processes of nodes, by their XML-RPC addresses or as roslaunch starts them."""

import contextlib
import os
import socket
import time
from urllib.parse import urlparse

import psutil
from rosgraph.names import ns_join
from rosgraph.network import is_local_address

# s of wall time; a process that ends has closed its files, but not yet its sockets.
ENDING_TIME = 1.0
LOOK_PERIOD = 0.01  # s of wall time
ANY_IP = '0.0.0.0', '::'  # of servers that listen on every address
NAME = '__name:='  # in the command line of a node that roslaunch has started


def pids_at(addresses):
    """Return the id of the process that serves each address, by name.

    None: this process cannot see it, since it is on another machine or belongs to another user, or
    no machine can have the address. 0: nothing serves it, as after a node was killed.
    """
    local = {}
    for name, address in addresses.items():
        with contextlib.suppress(ValueError):
            host, port = urlparse(address).hostname, urlparse(address).port
            if is_local_address(host):
                local[name] = host, port
    end = time.monotonic() + ENDING_TIME
    while True:
        listening = {connection.laddr: connection
                     for connection in psutil.net_connections('tcp')
                     if connection.status == psutil.CONN_LISTEN}
        pids = {name: _pid_at(*address, listening) for name, address in local.items()}
        if None not in pids.values() or time.monotonic() > end:
            return {**dict.fromkeys(addresses), **pids}
        time.sleep(LOOK_PERIOD)


def _pid_at(host, port, listening):
    ips = {ip for *_, (ip, *_) in socket.getaddrinfo(host, None)}
    return next((_opener_of(listening[ip, port]) for ip in (*ips, *ANY_IP)
                 if (ip, port) in listening), 0)


def _opener_of(connection):
    """Return the id of the process that has opened a socket; children that it forked have it, too.

    None: this process cannot see it.
    """
    pid = connection.pid
    try:
        socket_number = _socket_number(pid, connection.fd)
        for parent in psutil.Process(pid).parents():
            if _socket_number(parent.pid, connection.fd) == socket_number:
                pid = parent.pid
    except (OSError, psutil.Error):  # one has ended, has another file there, or is another user's
        pass
    return pid


def _socket_number(pid, descriptor):
    return os.stat(f'/proc/{pid}/fd/{descriptor}').st_ino


def roslaunched(master_uri):
    """Yield name and id of each process that roslaunch has started for a master."""
    for process in psutil.process_iter(['cmdline', 'environ']):
        environment = process.info['environ'] or {}
        names = [argument[len(NAME):] for argument in process.info['cmdline'] or ()
                 if argument.startswith(NAME)]
        if names and environment.get('ROS_MASTER_URI') == master_uri:
            yield ns_join(environment.get('ROS_NAMESPACE', '/'), names[0]), process.pid
