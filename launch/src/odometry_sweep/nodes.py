"""A ROS master and nodes that are started one after the other."""

import os
import subprocess

import rosgraph
from odometry_launch.graph import DemoError, Graph, check_address_space
from odometry_launch.keeping import Kept
from odometry_launch.launch_log import LaunchLog
from odometry_launch.ports import HeldPort


class Nodes(Graph):
    """A context in which nodes run, in simulated time."""

    def __init__(self):
        """Begin without any."""
        self._log = LaunchLog()
        self._running = {}

    def __enter__(self):
        """Start a master, and return once it answers."""
        check_address_space()
        self._port = HeldPort(0)
        os.environ['ROS_MASTER_URI'] = f'http://localhost:{self._port.number}'
        try:
            # roscore would give up after 10 s, which can be too few where much is running.
            self._start('the ROS master', 'rosmaster', '--core', '-p', self._port.number)
            self.wait_for(rosgraph.is_master_online, 'the ROS master does not answer')
            rosgraph.Master('/sweep').setParam('/use_sim_time', True)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        """Return when everything has ended: until then it may write logs."""
        for node in self._running.values():
            node.let_go()
        for node in self._running.values():
            node.wait()
        self._port.close()

    def start(self, package, script, *arguments):
        """Start a node."""
        self._start(script, 'rosrun', package, script, *arguments)

    def check(self):
        """Raise DemoError if one of them has ended."""
        self._log.read()
        for name, node in self._running.items():
            if node.poll() is not None:
                raise DemoError(f'{name} has ended: {self._log.reason()}')

    def _start(self, name, *command):
        self._running[name] = Kept(*command, stdout=self._log.file, stderr=subprocess.STDOUT)
