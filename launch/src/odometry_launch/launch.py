"""Run a launch file with its own ROS master, and notice when a node ends."""

import contextlib
import os
import queue
import subprocess
import threading
import time
import uuid

import rosgraph
import rospkg

from odometry_launch.launch_log import LaunchLog
from odometry_launch.ports import next_port, usual_master_port
from odometry_launch.process_guard import start_guarded

START_TIMEOUT = 180.0  # s; beside 60 busy processes a demo of 0.1 m takes 138 s in all
LOOK_PERIOD = 0.02  # s
RESPAWNED = 'rosout'  # roslaunch starts it again
# roslaunch waits only 10 s for a master that it starts itself, too short on a busy machine. This
# master is a child of roslaunch, so that it ends after the nodes.
COMMAND = ('rosmaster --core -p "$0" __log:="$1/$2/master.log" & '
           'exec roslaunch --wait --run_id "${@:2}"')


class DemoError(RuntimeError):
    """The demo cannot continue; the message is one line for the user."""


class Launch:
    """A context in which a master and the nodes of a launch file run."""

    def __init__(self, launch_file, arguments, may_end=(), package='odometry_launch'):
        """Take the name of a launch file, a dictionary of its arguments, and its package.

        :param may_end: names of nodes that end once they have done their task
        """
        self._command = [package, launch_file]
        self._command += [f'{name}:={value}' for name, value in arguments.items()]
        self._may_end = may_end

    def __enter__(self):
        """Start everything, and return at once; raise OSError if no port is free."""
        usual = usual_master_port()
        self._port = next_port(usual)
        self.is_at_usual_port = self._port.number == usual
        self.master_uri = f'http://localhost:{self._port.number}'
        os.environ['ROS_MASTER_URI'] = self.master_uri
        self._log = LaunchLog()
        self._roslaunch = start_guarded(
            'bash', '-c', COMMAND, self._port.number, rospkg.get_log_dir(), uuid.uuid1(),
            *self._command, stdout=self._log.file, stderr=subprocess.STDOUT,
            env={**os.environ, 'PYTHONUNBUFFERED': '1'})
        return self

    def __exit__(self, *_):
        """Wait until everything has ended; nodes may write logs until then."""
        self.terminate()
        self._roslaunch.wait()
        self._port.close()

    def terminate(self):
        """Start to end everything, and return at once."""
        self._roslaunch.terminate()

    def wait_until_read(self):
        """Return once the launch file has been read."""
        self.wait_for(rosgraph.is_master_online, 'the ROS master does not answer')
        # It answers before roslaunch has set the parameters.
        self.wait_for(lambda: rosgraph.Master('/demo').hasParam('/use_sim_time'),
                      'the launch file has not been read')

    def check(self):
        """Raise DemoError if roslaunch or a node has ended that should still run."""
        is_over = self._roslaunch.poll() is not None
        self._log.read()
        for name, how in self._log.ended.items():
            if name != RESPAWNED and (how or name not in self._may_end):
                raise DemoError(self._log.complaint or f'{name} has ended{how}')
        if is_over:
            raise DemoError(f'the nodes have ended: {self._log.reason()}')

    def wait_for(self, condition, complaint):
        """Return once the condition holds; raise DemoError if it fails, or takes too long."""
        end, outcome = time.monotonic() + START_TIMEOUT, queue.SimpleQueue()
        # On a thread, since a suspended master or node never answers.
        threading.Thread(target=_wait, args=[condition, outcome], daemon=True).start()
        while time.monotonic() < end:
            try:
                error = outcome.get(timeout=LOOK_PERIOD)
            except queue.Empty:
                self.check()
                continue
            if error:
                raise DemoError(f'{complaint}: {type(error).__name__}: {error}') from error
            return
        raise DemoError(f'{complaint} within {START_TIMEOUT:g} s; the nodes said last: '
                        f'{self._log.reason()}')


def _wait(condition, outcome):
    """Put None into a queue once a condition holds, or the error if it fails."""
    holds = False
    try:
        while not holds:
            time.sleep(LOOK_PERIOD)
            with contextlib.suppress(OSError, rosgraph.MasterException):  # no answer yet
                holds = condition()
        outcome.put(None)
    except Exception as error:  # noqa: BLE001
        outcome.put(error)
