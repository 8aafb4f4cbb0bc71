"""Python scripts that are forked from a process that has imported already what they need.

They run as they do for a user, from their first line to their exit status, but start in a tenth of
the time: imports are most of what a short test costs the processor.
"""

import ctypes
import multiprocessing
import os
import runpy
import signal
import subprocess
import sys
from contextlib import suppress
from multiprocessing import forkserver

import rosgraph
import rospy

from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

FORKS = multiprocessing.get_context('forkserver')
FORKS.set_forkserver_preload([
    'odometry_tests.forked', 'sim_turtlebot.simulator', 'tf.transformations', 'robot_view.address',
    'run_plot.figure'])
OUTPUTS = 1, 2  # descriptors
PR_SET_PDEATHSIG = 1  # <linux/prctl.h>


class Forked:
    """A script in a process and a session of its own, with the methods of GuardedProcess."""

    def __init__(self, script, *arguments, env, stdout, stderr):
        """Start it, with two files for its outputs."""
        outputs = [f'/proc/{os.getpid()}/fd/{file.fileno()}' for file in (stdout, stderr)]
        # A daemon ends with the process that has started it.
        self._process = FORKS.Process(target=_run, daemon=True, args=[
            [str(script), *map(str, arguments)], env, outputs])
        self._process.start()

    @property
    def pid(self):
        return self._process.pid

    def poll(self):
        """Return the exit status as subprocess does, None while it is running."""
        return self._process.exitcode

    def wait(self, timeout=None):
        """Return the exit status once it has ended; raise subprocess.TimeoutExpired."""
        self._process.join(timeout)
        if self.poll() is None:
            raise subprocess.TimeoutExpired(self._process.name, timeout)
        return self.poll()

    def send_signal(self, signum):
        if self.poll() is None:
            with suppress(ProcessLookupError):
                os.kill(self.pid, signum)

    def terminate(self):
        self._process.kill()


def run_script(script, *arguments, env=None):
    """Run a script by its path in the project to its end, and return its Process.

    :param env: is added to the environment
    """
    with Process(ROOT / script, *arguments, env=env, start=Forked) as process:
        process.wait()
    return process


def _run(argv, environment, outputs):
    os.setsid()
    # The fork server ends when pytest does, however that ends, unless a child holds this pipe; and
    # its children end with it.
    os.close(forkserver._forkserver._forkserver_alive_fd)
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)
    for descriptor, output in zip(OUTPUTS, outputs):
        os.dup2(os.open(output, os.O_WRONLY | os.O_APPEND), descriptor)
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = argv
    # When rospy was imported it has read another command line, and another ROS_NAMESPACE.
    rospy.names.reload_mappings(argv)
    rospy.names._set_caller_id(f'{rosgraph.names.get_ros_namespace()}unnamed')
    runpy.run_path(argv[0], run_name='__main__')
