"""The page beside the demo and beside every launch file."""

import errno
import os
import pty
import re
import signal
import socket
import subprocess
import urllib.request

import pytest
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

PORT = 8080
PAGE = f'http://localhost:{PORT}'
STAYS = 'The page stays'

pytest.importorskip('viser', reason='viser is not installed')


@pytest.fixture(autouse=True)
def port():
    """Skip if another program has the page's port."""
    try:
        socket.create_server(('localhost', PORT)).close()
    except OSError:
        pytest.skip(f'port {PORT} is taken')


def assert_the_page_is_served():
    """Fetch it, as a browser does."""
    with urllib.request.urlopen(PAGE, timeout=TIMEOUT * PATIENCE) as answer:
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
        demo.wait_for(f'view            {PAGE}', 60.0)
        demo.wait_for(STAYS, 60.0)
        assert_the_page_is_served()
        assert demo.interrupt() == 0, demo.output
    assert 'moved distance' in demo.output
    assert 'Traceback' not in demo.output
    with socket.socket() as connection:
        assert connection.connect_ex(('localhost', PORT)) == errno.ECONNREFUSED


def test_without_a_terminal_the_demo_ends_as_without_a_page():
    """Nobody could press Ctrl-C."""
    with Process(ROOT / 'ws', 'demo', '--view', 'rotate', '--target', '20',
                 '--real-time-factor', '0') as demo:
        assert demo.wait(60.0) == 0, demo.output
    assert f'view            {PAGE}' in demo.stdout.splitlines()
    assert STAYS not in demo.stdout


def test_the_demo_says_where_its_page_is_when_the_usual_port_is_taken():
    """On the next one that is free: this machine may have any number of demos."""
    with socket.create_server(('localhost', PORT)), \
            Process(ROOT / 'ws', 'demo', '--view', '--distance', '0.1',
                    '--real-time-factor', '0') as demo:
        assert demo.wait(60.0) == 0, demo.output
    found = re.search(r'^view            http://localhost:(\d+)$', demo.stdout, re.MULTILINE)
    assert found and PORT < int(found[1]) < PORT + 100, demo.output


@pytest.mark.parametrize('launch_file', ['sim.launch', 'move_two_meters.launch', 'rotate.launch'])
def test_every_launch_file_can_open_the_page(master, launch_file):
    """view:=true."""
    with Process('roslaunch', 'odometry_launch', launch_file, 'view:=true') as launch:
        launch.wait_for_output(f'view: {PAGE}', 40.0)
        assert_the_page_is_served()
        assert launch.end(timeout=30.0) == 0, launch.output
    assert 'has died' not in launch.output
