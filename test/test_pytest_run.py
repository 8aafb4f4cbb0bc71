"""What ./ws test adds to pytest tells the truth about the tests."""

import os
import subprocess
import sys

import pytest
from odometry_tests.processes import ATTEMPTS, GAVE_UP
from odometry_tests.scripts import ROOT

OUTCOMES = """
import os, pytest
def test_good(): pass
def test_bad(): assert False
def test_left(): pytest.skip('no X')
@pytest.fixture
def broken(): raise OSError
def test_without_fixture(broken): pass
"""
CRASH = 'import os\ndef test_crash(): os._exit(0)\n'
CASES = """<testsuite><testcase name="good"/><testcase name="bad"><failure>it said no</failure></testcase>
<testcase name="left"><skipped message="no X"/></testcase></testsuite>"""
# In place of rostest: gives up as often as a file says, and then writes what another one says.
FAKE_ROSTEST = f"""#!/bin/sh
echo >>{{folder}}/runs
[ $(wc -l <{{folder}}/runs) -gt {{gives_up}} ] || {{{{ echo '{GAVE_UP}'; exit 1; }}}}
cp {{folder}}/cases $2/cases.xml
exit {{status}}
"""


@pytest.fixture
def run(tmp_path):
    """Return a function that runs pytest on the files in a folder."""
    def run_pytest(*arguments, **variables):
        return subprocess.run(
            [sys.executable, '-m', 'pytest', '-c', ROOT / 'pytest.ini', '--rootdir', tmp_path,
             '-o', 'cache_dir=cache', '-p', 'odometry_tests.pytest_run',
             '-p', 'odometry_tests.rostest_items', *arguments, tmp_path], cwd=tmp_path,
            env={**os.environ, 'ODOMETRY_ROOT': str(tmp_path), **variables},
            check=False, capture_output=True, text=True)
    return run_pytest


@pytest.fixture
def rostest(tmp_path, run):
    """Return a function that runs pytest on a .test file, with a rostest that gives up so often."""
    def run_rostest(cases, status, gives_up=0):
        (tmp_path / 'node.test').touch()
        (tmp_path / 'cases').write_text(cases)
        command = tmp_path / 'rostest'
        command.write_text(FAKE_ROSTEST.format(folder=tmp_path, gives_up=gives_up, status=status))
        command.chmod(0o755)
        return run(PATH=f'{tmp_path}:{os.environ["PATH"]}')
    return run_rostest


def last_line(run):
    """Return the last line of an output."""
    return run.stdout.splitlines()[-1]


def test_the_last_line_counts_everything_that_failed(tmp_path, run):
    """Also a fixture, and a worker that has crashed."""
    (tmp_path / 'test_outcomes.py').write_text(OUTCOMES)
    (tmp_path / 'test_crash.py').write_text(CRASH)
    found = run('-n', '2', '--dist', 'loadfile')
    assert last_line(found) == '1 passed, 3 failed, 1 skipped', found.stdout
    assert found.returncode == 1


def test_a_run_of_no_test_is_not_green(run):
    """Such as one of a misspelled name."""
    found = run()
    assert last_line(found) == '0 passed, 0 failed, 0 skipped', found.stdout
    assert found.returncode != 0


def test_each_case_of_a_rostest_is_reported(rostest):
    """With what it said."""
    found = rostest(CASES, status=1)
    assert last_line(found) == '1 passed, 1 failed, 1 skipped', found.stdout
    assert 'node.test bad' in found.stdout and 'it said no' in found.stdout
    assert found.returncode == 1


@pytest.mark.parametrize('cases, status', [('<testsuite/>', 0), ('<testsuite/>', 1),
                                           ('<testsuite><testcase name="good"/></testsuite>', 1)])
def test_a_rostest_that_ended_early_has_failed(rostest, cases, status):
    """Whatever its exit status, if it has no case; and whatever its cases, if that is not 0."""
    found = rostest(cases, status)
    assert ', 1 failed, ' in last_line(found) and found.returncode == 1, found.stdout


@pytest.mark.parametrize('gives_up, status', [(1, 0), (ATTEMPTS, 1)])
def test_a_rostest_that_gives_up_its_master_is_run_again(rostest, gives_up, status):
    """As roslaunch does after ten seconds, however busy the machine is; but not for ever."""
    found = rostest('<testsuite><testcase name="good"/></testsuite>', 0, gives_up)
    assert found.returncode == status, found.stdout


def test_every_test_file_is_found():
    """Wherever it lies."""
    found = subprocess.run([sys.executable, '-m', 'pytest', '--collect-only', '-q'], cwd=ROOT,
                           check=False, capture_output=True, text=True)
    collected = {line.partition(': ')[0] for line in found.stdout.splitlines()}
    there = {str(path.relative_to(ROOT)) for pattern in ('test_*.py', '*.test')
             for folder in ROOT.glob('[!.]*/') if folder.name not in ('docs', 'runs')
             for path in folder.rglob(pattern) if path.parent.name != 'src'}
    assert there and there <= collected, there - collected


def test_bare_pytest_says_what_to_do():
    """In one line, where ROS is not sourced."""
    found = subprocess.run([sys.executable, '-m', 'pytest'], cwd=ROOT, env={'PATH': os.environ['PATH']},
                           check=False, capture_output=True, text=True)
    assert found.returncode != 0
    assert len(found.stderr.splitlines()) == 1 and './ws test' in found.stderr, found.stderr
