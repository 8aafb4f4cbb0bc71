"""On which addresses processes listen."""

import contextlib
import ipaddress

import psutil


def listening_addresses(pid):
    """Return the IP addresses on which a process and its descendants listen for TCP connections.

    There are none if it has ended.
    """
    family = {pid}
    with contextlib.suppress(psutil.NoSuchProcess):
        family |= {child.pid for child in psutil.Process(pid).children(recursive=True)}
    return {socket.laddr.ip for socket in psutil.net_connections('tcp')
            if socket.status == psutil.CONN_LISTEN and socket.pid in family}


def assert_loopback(addresses):
    """Assert that there are IP addresses, and that nobody but this machine reaches them."""
    assert addresses
    assert all(ipaddress.ip_address(address).is_loopback for address in addresses), addresses


def assert_loopback_only(pid):
    """Assert that a process and its descendants listen, and nobody but this machine reaches them."""
    assert_loopback(listening_addresses(pid))
