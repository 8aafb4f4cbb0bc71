"""Queries about other processes."""

import ipaddress

import psutil

MARK = 'ODOMETRY_UNDER_TEST'


def marked(mark):
    return [process for process in psutil.process_iter(['cmdline', 'environ'])
            if (process.info['environ'] or {}).get(MARK) == mark]


def assert_loopback_only(pid):
    """Assert that a process and its descendants listen, and on loopback only."""
    family = {pid, *(child.pid for child in psutil.Process(pid).children(recursive=True))}
    addresses = {socket.laddr.ip for socket in psutil.net_connections('tcp')
                 if socket.status == psutil.CONN_LISTEN and socket.pid in family}
    assert addresses
    assert all(ipaddress.ip_address(address).is_loopback for address in addresses), addresses
