"""Find the processes that serve the XML-RPC addresses of nodes."""

import socket
from urllib.parse import urlparse

import psutil
from rosgraph.network import is_local_address

ANY_IP = '0.0.0.0', '::'  # of servers that listen on every address


def pids_at(addresses):
    """Return the id of the process that serves each address, by name.

    None: this process cannot see it, since it is on another machine or belongs to another user. 0:
    nothing serves the address, as after a node was killed.
    """
    listening = {connection.laddr: connection.pid for connection in psutil.net_connections('tcp')
                 if connection.status == psutil.CONN_LISTEN}
    return {name: _pid_at(urlparse(address), listening) for name, address in addresses.items()}


def _pid_at(address, listening):
    if not is_local_address(address.hostname):
        return None
    ips = {ip for *_, (ip, *_) in socket.getaddrinfo(address.hostname, None)}
    return next((listening[ip, address.port] for ip in (*ips, *ANY_IP)
                 if (ip, address.port) in listening), 0)
