"""What tests ask the system of other processes."""

import ipaddress
import uuid

import psutil

from odometry_tests.waiting import wait_until

LOOK_PERIOD = 0.2  # s; each look goes through all processes there are


def new_mark():
    """Return a variable for the environment of processes, by which they are found, as a dictionary."""
    return {'ODOMETRY_UNDER_TEST': str(uuid.uuid4())}


def marked(mark):
    """Return the ids of the processes that have the mark in their environment."""
    (name, value), = mark.items()
    return [process.pid for process in psutil.process_iter(['environ'])
            if (process.info['environ'] or {}).get(name) == value]


def wait_until_none(mark, timeout=15.0):
    """Return once no process has the mark."""
    wait_until(lambda: not marked(mark), timeout,
               lambda: f'the end of\n{command_lines(marked(mark))}', LOOK_PERIOD)


def command_lines(pids):
    """Return the command lines of those processes that still run as a text, one in each line."""
    return '\n'.join(' '.join(process.info['cmdline'] or []) for process
                     in psutil.process_iter(['cmdline']) if process.pid in pids)


def assert_loopback_only(pid):
    """Assert that a process and its descendants listen, and nobody but this machine reaches them."""
    family = {pid, *(child.pid for child in psutil.Process(pid).children(recursive=True))}
    addresses = {socket.laddr.ip for socket in psutil.net_connections('tcp')
                 if socket.status == psutil.CONN_LISTEN and socket.pid in family}
    assert addresses
    assert all(ipaddress.ip_address(address).is_loopback for address in addresses), addresses
