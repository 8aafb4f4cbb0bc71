"""A pytest plugin: each .test file is an item, run by rostest, whose test cases are reported."""

import os
import signal
import subprocess
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import pytest
from odometry_launch.process_guard import GuardedProcess

from odometry_tests.processes import ATTEMPTS, GAVE_UP

END_TIMEOUT = 20.0  # s; an interrupted rostest ends its nodes first


def pytest_collect_file(file_path, parent):
    """Collect the .test files, wherever they are."""
    if file_path.suffix == '.test':
        return RostestFile.from_parent(parent, path=file_path)
    return None


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item):
    """Report each test case of a rostest; those that failed last, so that --lf remembers them."""
    if not isinstance(item, Rostest):
        return None
    item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
    for report in sorted(item.runtest(), key=lambda report: report.failed):
        item.ihook.pytest_runtest_logreport(report=report)
    item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
    return True


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
        """Run it, and return a TestReport for each of its cases; one failed if there is none."""
        with tempfile.TemporaryDirectory() as folder:
            status, output = self._run_until_master_answers(folder)
            reports = [report for file in sorted(Path(folder).rglob('*.xml'))
                       for report in self._read(file)]
        if not reports or (status and not any(report.failed for report in reports)):
            reports.append(self._report('rostest', 'failed', f'{output}\nexit status {status}'))
        return reports

    def _run_until_master_answers(self, folder):
        # roslaunch gives its master ten seconds of wall time, however busy the machine is.
        for _ in range(ATTEMPTS):
            status, output = self._run(folder)
            if GAVE_UP not in output:
                break
        return status, output

    def _run(self, folder):
        # rostest needs a path without spaces: where ./ws is used, ODOMETRY_ROOT is one.
        root = self.config.rootpath
        file = Path(os.environ.get('ODOMETRY_ROOT', root), self.path.relative_to(root))
        with tempfile.TemporaryFile() as output:
            process = GuardedProcess('rostest', '--results-base-dir', folder, file, cwd=folder, stdout=output,
                           stderr=subprocess.STDOUT)
            try:
                status = process.wait()
            except BaseException:
                process.send_signal(signal.SIGINT)
                process.wait(END_TIMEOUT)
                raise
            output.seek(0)
            return status, output.read().decode(errors='replace').strip()

    def _read(self, file):
        for case in ElementTree.parse(file).getroot().iter('testcase'):
            bad = [*case.iter('failure'), *case.iter('error')]
            skipped = case.find('skipped')
            name, seconds = case.get('name'), float(case.get('time') or 0.0)
            if bad:
                yield self._report(name, 'failed', bad[0].text or bad[0].get('message'), seconds)
            elif skipped is not None:
                reason = str(self.path), 0, f'Skipped: {skipped.get("message")}'
                yield self._report(name, 'skipped', reason, seconds)
            elif not file.name.startswith('rostest-'):  # those say only that a script has run
                yield self._report(name, 'passed', None, seconds)

    def _report(self, name, outcome, said, seconds=0.0):
        location = (*self.location[:2], f'{self.path.name} {name}')
        return pytest.TestReport(self.nodeid, location, {}, outcome, said, 'call', duration=seconds)
