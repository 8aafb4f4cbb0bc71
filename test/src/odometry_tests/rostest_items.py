"""A pytest plugin: each .test file is an item, run by rostest, whose verdict it has."""

import os
import sys
import tempfile
from pathlib import Path

import pytest

from odometry_tests.processes import Process

TIMEOUT = 1000.0  # s; each test in a file has a limit of its own
# rostest waits ten seconds for its master, too few on a busy machine.
ROSTEST = f"""
import roslaunch.launch
from rostest import rostestmain
roslaunch.launch._TIMEOUT_MASTER_START = {TIMEOUT}
rostestmain()
"""


def pytest_collect_file(file_path, parent):
    if file_path.suffix == '.test':
        return RostestFile.from_parent(parent, path=file_path)
    return None


class RostestFile(pytest.File):
    """A .test file."""

    def collect(self):
        """Yield its one item: rostest starts all of its nodes together."""
        yield Rostest.from_parent(self, name='rostest')


class Rostest(pytest.Item):
    """A run of rostest, in a process and with a master of its own."""

    def reportinfo(self):
        return self.path, None, self.path.name

    def runtest(self):
        # rostest needs a path without spaces: where ./ws is used, ODOMETRY_ROOT is one.
        root = self.config.rootpath
        file = Path(os.environ.get('ODOMETRY_ROOT', root), self.path.relative_to(root))
        with tempfile.TemporaryDirectory() as folder, Process(
                sys.executable, '-c', ROSTEST, '--results-base-dir', folder, file, cwd=folder) as run:
            status = run.wait(TIMEOUT)
        assert status == 0 and 'RESULT: SUCCESS' in run.stdout, run.output
