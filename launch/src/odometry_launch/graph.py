"""A tutorial's nodes and their ROS master, as roslaunch starts them."""

import contextlib
import os
import resource
import subprocess
import threading
import time
import uuid

import rosgraph
import rospkg

from odometry_launch.keeping import Kept
from odometry_launch.launch_log import LaunchLog
from odometry_launch.ports import master_port

START_TIMEOUT = 180.0  # s; beside 60 busy processes a demo of 0.1 m takes 138 s in all
LOOK_PERIOD = 0.02  # s
# With half of it some threads cannot start, and whoever needs them waits for ever.
ADDRESS_SPACE = 2 * 10**9  # bytes
RESPAWNED = 'rosout'  # roslaunch starts it again
# roslaunch would give a master of its own 10 s, which can be too few where much is running. As its
# child this one is ended after the nodes.
LAUNCH = ('rosmaster --core -p "$0" __log:="$1/$2/master.log" & '
          'exec roslaunch --wait --run_id "${@:2}"')


class DemoError(RuntimeError):
    """The demo cannot go on; the message is one line for the user."""


class Graph:
    """A context in which the nodes run."""

    def __init__(self, launch_file, arguments, may_end=(), package='odometry_launch'):
        """Take the name of a launch file and a dictionary of its arguments.

        :param may_end: names of nodes that end when they have done what they were told
        :param package: that has the launch file
        """
        self._command = [package, launch_file,
                         *(f'{name}:={value}' for name, value in arguments.items())]
        self._may_end = may_end

    def __enter__(self):
        """Start everything, and return at once."""
        check_address_space()
        self._port = master_port()
        os.environ['ROS_MASTER_URI'] = f'http://localhost:{self._port.number}'
        self._log = LaunchLog()
        self._roslaunch = Kept('bash', '-c', LAUNCH, self._port.number, rospkg.get_log_dir(),
                               uuid.uuid1(), *self._command,
                               stdout=self._log.file, stderr=subprocess.STDOUT,
                               env={**os.environ, 'PYTHONUNBUFFERED': '1'})
        return self

    def __exit__(self, *_):
        """Return when everything has ended: until then it may write logs."""
        self.let_go()
        self._roslaunch.wait()
        self._port.close()

    def let_go(self):
        """Let everything end; return at once."""
        self._roslaunch.let_go()

    def wait_until_read(self):
        """Return once the launch file has been read."""
        self.wait_for(rosgraph.is_master_online, 'the ROS master does not answer')
        # The master is up a moment before it says whose clock rules.
        self.wait_for(lambda: rosgraph.Master('/demo').hasParam('/use_sim_time'),
                      'the launch file has not been read')

    @property
    def unusual_address(self):
        """Where the master is if rostopic would not look for it there, else None."""
        return None if self._port.is_first_choice else os.environ['ROS_MASTER_URI']

    def check(self):
        """Raise DemoError if the nodes have ended by themselves, or one of them has."""
        is_over = self._roslaunch.poll() is not None
        self._log.read()
        for name, how in self._log.ended.items():
            if name != RESPAWNED and (how or name not in self._may_end):
                raise DemoError(self._log.complaint or f'{name} has ended{how}')
        if is_over:
            raise DemoError(f'the nodes have ended: {self._log.reason()}')

    def wait_for(self, condition, complaint):
        """Return once the condition holds; raise DemoError if it fails, or takes too long.

        It is checked in a thread, since rospy and the master may block for ever.
        """
        ended, failures = threading.Event(), []

        def look():
            try:
                while not _holds(condition):
                    time.sleep(LOOK_PERIOD)
            except BaseException as error:  # noqa: BLE001
                failures.append(f'{type(error).__name__}: {error}')
            ended.set()

        threading.Thread(target=look, daemon=True).start()
        end = time.monotonic() + START_TIMEOUT
        while not ended.wait(LOOK_PERIOD):
            self.check()
            if time.monotonic() > end:
                raise DemoError(f'{complaint} within {START_TIMEOUT:g} s; the nodes said last: '
                                f'{self._log.reason()}')
        if failures:
            raise DemoError(f'{complaint}: {failures[0]}')


def _holds(condition):
    with contextlib.suppress(OSError, rosgraph.MasterException):  # no answer yet
        return condition()


def check_address_space():
    """Raise DemoError if the nodes, which inherit the limit, may have too little."""
    most, _ = resource.getrlimit(resource.RLIMIT_AS)
    if most != resource.RLIM_INFINITY and most < ADDRESS_SPACE:
        raise DemoError(f'the address space is limited to {most // 1024} kB (ulimit -v), but must '
                        f'be at least {ADDRESS_SPACE // 1024} kB')
