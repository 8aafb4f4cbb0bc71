"""Scripts that are forked from a process that has imported already what they need.

They run as they do for a user, from their first line to their exit status, in a tenth of the time.
"""

import multiprocessing
import os
import runpy
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import rospy

from odometry_tests.scripts import ROOT
from odometry_tests.waiting import PATIENCE, TIMEOUT

FORKS = multiprocessing.get_context('forkserver')
FORKS.set_forkserver_preload(['odometry_tests.forked', 'sim_turtlebot.node', 'tf.transformations',
                              'robot_view.address', 'odometry_launch.run_plot'])


class Ended(NamedTuple):
    """How a script has ended, and what it has printed."""

    status: int
    stdout: str
    stderr: str


def run_script(script, *arguments, env=None):
    """Run a script by its path in the project; return how it Ended.

    :param env: is added to the environment
    """
    with TemporaryDirectory() as folder:
        files = [Path(folder, name) for name in ('stdout', 'stderr')]
        process = FORKS.Process(target=_run, args=[
            str(ROOT / script), arguments, {**os.environ, **(env or {})}, files], daemon=True)
        process.start()
        process.join(TIMEOUT * PATIENCE)
        if process.exitcode is None:
            process.kill()
            process.join()
        return Ended(process.exitcode, *(file.read_text() for file in files))


def _run(script, arguments, environment, files):
    for descriptor, file in enumerate(files, 1):
        os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT), descriptor)
    os.environ.clear()
    os.environ.update(environment)
    sys.argv = [script, *arguments]
    # rospy has read another command line when it was imported.
    rospy.names.reload_mappings(sys.argv)
    runpy.run_path(script, run_name='__main__')
