"""Which process serves an address: one of this machine, of another user, of another machine, or none."""

import os
import socket
import subprocess
import sys
import types

import psutil
import pytest
from odometry_common.connections import ask
from sim_turtlebot.lockstep import listeners

PORT = 4321
TIMEOUT = 60.0  # s
NEIGHBOURS = '''
import socket, sys, time
servers = [socket.create_server((f'127.99.0.{number}', int(sys.argv[1]))) for number in range(1, 50)]
print('listening', flush=True)
time.sleep(60)
'''


@pytest.fixture
def look(monkeypatch):
    """Have each look at the connections find the next of these processes at PORT: an id, or None; () for none."""
    def looks(*found):
        rows = [[types.SimpleNamespace(laddr=('127.0.0.1', PORT), pid=pid, fd=-1, status=psutil.CONN_LISTEN)]
                if pid != () else [] for pid in found]
        if len(found) > 1:
            monkeypatch.setattr(listeners, 'ENDING_TIME', TIMEOUT)
        monkeypatch.setattr(psutil, 'net_connections', lambda kind: rows.pop(0) if len(rows) > 1 else rows[0])
        return listeners.pids_at({'/node': f'http://127.0.0.1:{PORT}/'})['/node']
    return looks


@pytest.mark.parametrize('found, pid', [([None, None, ()], 0), ([None, 42], 42), ([None], None)],
                         ids=['ending', 'starting', 'hidden'])
def test_a_process_that_ends_or_starts_is_looked_at_again(look, found, pid):
    """Its sockets are there for some time without its open files, by which it is found."""
    assert look(*found) == pid


def test_no_process_has_an_address_that_cannot_be():
    """The master takes any address."""
    addresses = {'/node': 'http://localhost:99999/', '/other': 'http://[::1:5/'}
    assert listeners.pids_at(addresses) == {'/node': None, '/other': None}
    assert [ask(address, 'getPid') for address in addresses.values()] == [None, None]


def test_a_socket_is_that_of_the_process_that_opened_it():
    """Not of its children, as after multiprocessing.Pool(), nor of one at the same port of other addresses of loopback."""
    with socket.create_server(('127.0.0.1', 0)) as server:
        port = server.getsockname()[1]
        with subprocess.Popen([sys.executable, '-c', NEIGHBOURS, str(port)], pass_fds=[server.fileno()],
                              stdout=subprocess.PIPE) as other:
            assert other.stdout.readline() == b'listening\n'
            assert listeners.pids_at({'/node': f'http://127.0.0.1:{port}/'}) == {'/node': os.getpid()}
            other.kill()
