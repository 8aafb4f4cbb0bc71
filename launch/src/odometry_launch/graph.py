"""A tutorial's nodes and their ROS master, as roslaunch starts them."""

import os
import signal
import socket
import subprocess
import tempfile
import time
from urllib.parse import urlparse

import rosgraph

START_TIMEOUT = 60.0  # s; much is running on some machines
STOP_TIMEOUT = 20.0  # s; roslaunch gives its nodes 15


class DemoError(RuntimeError):
    """The demo cannot go on; the message is one line for the user."""


class Graph:
    """A context in which the nodes run."""

    def __init__(self, launch_file, arguments):
        """Take the name of a launch file and a dictionary of its arguments."""
        self._command = [launch_file, *(f'{name}:={value}' for name, value in arguments.items())]

    def __enter__(self):
        """Start everything and return once the launch file has been read."""
        port = _free_port()
        os.environ['ROS_MASTER_URI'] = f'http://localhost:{port}'
        self._log = tempfile.TemporaryFile('w+')
        self._process = subprocess.Popen(
            ['roslaunch', '-p', str(port), 'odometry_launch', *self._command],
            stdout=self._log, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            self.wait_for(rosgraph.is_master_online, 'the ROS master does not answer')
            # The master is up a moment before it says whose clock rules.
            self.wait_for(lambda: rosgraph.Master('/demo').hasParam('/use_sim_time'),
                          'the launch file has not been read')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        """End everything."""
        self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(STOP_TIMEOUT)
        except subprocess.TimeoutExpired:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()
        self._log.close()

    def check(self):
        """Raise DemoError if the nodes have ended by themselves."""
        if self._process.poll() is not None:
            self._log.seek(0)
            raise DemoError(f'the nodes ended too early; they said:\n{self._log.read().strip()}')

    def wait_for(self, condition, complaint):
        """Return once the condition holds; raise DemoError if it takes too long."""
        end = time.monotonic() + START_TIMEOUT
        while not condition():
            self.check()
            if time.monotonic() > end:
                raise DemoError(f'{complaint} within {START_TIMEOUT:g} s')
            time.sleep(0.02)


def _free_port():
    """Return the usual port if nobody has it, so that rostopic finds the demo, else another."""
    usual = urlparse(os.environ.get('ROS_MASTER_URI', '')).port or rosgraph.DEFAULT_MASTER_PORT
    for port in (usual, 0):
        with socket.socket() as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind(('localhost', port))
            except OSError:
                continue
            return probe.getsockname()[1]
    raise DemoError('there is no free port for a ROS master')
