"""A pytest plugin: each .test file is an item, run by rostest, whose verdict it has."""

import os
import tempfile
from pathlib import Path

import pytest

from odometry_tests.processes import ATTEMPTS, GAVE_UP, Process

TIMEOUT = 1000.0  # s; each test in a file has a limit of its own


def pytest_collect_file(file_path, parent):
    """Collect the .test files, wherever they are."""
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
        """Return the place of the item, and its name in the output."""
        return self.path, None, self.path.name

    def runtest(self):
        """Run it, again if it has given up its master, as on a busy machine."""
        # rostest needs a path without spaces: where ./ws is used, ODOMETRY_ROOT is one.
        root = self.config.rootpath
        file = Path(os.environ.get('ODOMETRY_ROOT', root), self.path.relative_to(root))
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(ATTEMPTS):
                with Process('rostest', '--results-base-dir', folder, file, cwd=folder) as run:
                    try:
                        status = run.wait(TIMEOUT)
                    except AssertionError:
                        if GAVE_UP not in run.output:
                            raise
                if GAVE_UP not in run.output:
                    break
        assert GAVE_UP not in run.output and status == 0 and 'RESULT: SUCCESS' in run.stdout, run.output

    def repr_failure(self, excinfo):
        """Return what it has printed."""
        failed = isinstance(excinfo.value, AssertionError)
        return str(excinfo.value) if failed else super().repr_failure(excinfo)
