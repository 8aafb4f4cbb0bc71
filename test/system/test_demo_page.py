"""The page beside the demo and beside every launch file."""

import contextlib
import errno
import os
import pty
import re
import signal
import socket
import subprocess
import urllib.request

import pytest
from odometry_tests.listening import assert_loopback_only
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

USUAL_PORT = 8080
ADDRESS = re.compile(r'^view            (http://localhost:(\d+))\r?$', re.MULTILINE)
STAYS = 'The page stays'

pytest.importorskip('viser', reason='viser is not installed')


def assert_the_page_is_served(url):
    """Fetch it, as a browser does."""
    with urllib.request.urlopen(url, timeout=TIMEOUT * PATIENCE) as answer:
        assert b'viser' in answer.read().lower()


class Terminal:
    """A demo on a terminal, as a user sees it."""

    def __init__(self, *arguments):
        """Start it."""
        self._reader, terminal = pty.openpty()
        self._process = subprocess.Popen([ROOT / 'ws', 'demo', *arguments], stdin=terminal,
                                         stdout=terminal, stderr=terminal)
        os.close(terminal)
        os.set_blocking(self._reader, False)
        self._bytes = b''

    def __enter__(self):
        """Use it as a context, at whose end it has ended."""
        return self

    def __exit__(self, *_):
        """End it."""
        if self._process.poll() is None:
            self.interrupt()
        os.close(self._reader)

    @property
    def pid(self):
        """Process id of the demo itself."""
        return self._process.pid

    @property
    def output(self):
        """What it has printed so far."""
        try:
            while chunk := os.read(self._reader, 4096):
                self._bytes += chunk
        except OSError:
            pass  # nothing more for now, or for ever
        return self._bytes.decode()

    def wait_for(self, text, timeout):
        """Return once a text has been printed."""
        wait_until(lambda: text in self.output, timeout, lambda: f'{text!r} in:\n{self.output}')

    def interrupt(self):
        """Press Ctrl-C and return the exit status."""
        self._process.send_signal(signal.SIGINT)
        return self._process.wait(TIMEOUT * PATIENCE)


def test_on_a_terminal_the_page_stays_after_the_run():
    """Until Ctrl-C, which then is no failure."""
    with Terminal('--view', '--distance', '0.3', '--speed', '0.3') as demo:
        demo.wait_for(STAYS, 60.0)
        url, port = ADDRESS.search(demo.output).groups()
        assert USUAL_PORT <= int(port) < USUAL_PORT + 100
        assert_the_page_is_served(url)
        assert_loopback_only(demo.pid)
        assert demo.interrupt() == 0, demo.output
    assert 'moved distance' in demo.output
    assert 'Traceback' not in demo.output
    with socket.socket() as connection:
        assert connection.connect_ex(('localhost', int(port))) == errno.ECONNREFUSED


def test_without_a_terminal_the_demo_ends_as_without_a_page():
    """Nobody could press Ctrl-C. While the usual port is taken, the page has a later one."""
    with contextlib.ExitStack() as stack:
        # If it cannot be taken here, somebody else has it, which is as good.
        with contextlib.suppress(OSError):
            stack.enter_context(socket.create_server(('localhost', USUAL_PORT)))
        demo = Process(ROOT / 'ws', 'demo', '--view', 'rotate', '--target', '20',
                       '--real-time-factor', '0')
        assert demo.wait(60.0) == 0, demo.output
    assert STAYS not in demo.stdout
    assert USUAL_PORT < int(ADDRESS.search(demo.stdout)[2]) < USUAL_PORT + 100, demo.output


@pytest.mark.parametrize('launch_file', ['sim.launch', 'move_two_meters.launch', 'rotate.launch'])
def test_every_launch_file_can_open_the_page(master, launch_file):
    """view:=true."""
    with hold_port() as port, Process('roslaunch', 'odometry_launch', launch_file, 'view:=true',
                                      f'view_port:={port}') as launch:
        launch.wait_for_output(f'view: http://localhost:{port}', 40.0)
        assert_the_page_is_served(f'http://localhost:{port}')
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output
