"""Queries about other processes."""

import ipaddress
import re
from pathlib import Path

import psutil

MARK = 'ODOMETRY_UNDER_TEST'


def marked(mark):
    return [process for process in psutil.process_iter(['cmdline', 'environ'])
            if (process.info['environ'] or {}).get(MARK) == mark]


def signals(pid, which):
    """Return the numbers of the signals that a process blocks (SigBlk) or ignores (SigIgn)."""
    found = re.search(rf'{which}:\t(\w+)', Path(f'/proc/{pid}/status').read_text())
    return [number for number in range(1, 65) if int(found[1], 16) >> number - 1 & 1]


def assert_loopback_only(pid):
    """Assert that a process and its descendants listen, and on loopback only."""
    family = {pid, *(child.pid for child in psutil.Process(pid).children(recursive=True))}
    addresses = {socket.laddr.ip for socket in psutil.net_connections('tcp')
                 if socket.status == psutil.CONN_LISTEN and socket.pid in family}
    assert addresses
    assert all(ipaddress.ip_address(address).is_loopback for address in addresses), addresses
