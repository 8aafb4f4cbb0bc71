"""Run the linters and every test, and count what happened."""

import argparse
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[1]
TESTS = ROOT / 'test'
WORKSPACE = ROOT / '.ws'
RESULTS = WORKSPACE / 'build' / 'test_results'
# Most tests wait most of the time, for each other's processes and for real time.
JOBS = 4
LINTERS = {
    'ruff': ['ruff', 'check', '--quiet', str(ROOT)],
    'catkin_lint': ['catkin_lint', '--quiet', str(ROOT)],
}


class Counts(NamedTuple):
    """How many tests ended in which way."""

    passed: int
    failed: int
    skipped: int

    def __add__(self, other):
        """Return the sums."""
        return Counts(*map(sum, zip(self, other)))


def main():
    """Exit 0 only if something ran and nothing failed."""
    options = _parse()
    # Who starts a process in the background has it ignore Ctrl-C; the tests press it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    if options.nightly:
        os.environ['HYPOTHESIS_PROFILE'] = 'nightly'
    linters = _start_linters()
    counts = _run_tests(options.names) + _count_findings(linters)
    print(f'{counts.passed} passed, {counts.failed} failed, {counts.skipped} skipped')
    sys.exit(0 if counts.passed and not counts.failed else 1)


def _parse():
    parser = argparse.ArgumentParser(prog='./ws test', description=__doc__)
    parser.add_argument('names', nargs='*', metavar='NAME', type=_existing_test,
                        help='run only these, such as test_heading or detector.test')
    parser.add_argument('--nightly', action='store_true',
                        help='try many more random sequences; takes hours')
    return parser.parse_args()


def _start_linters():
    """Have them read the sources while the tests run."""
    return {name: subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True) for name, command in LINTERS.items()}


def _count_findings(linters):
    counts = Counts(0, 0, 0)
    for name, linter in linters.items():
        stdout, stderr = linter.communicate()
        findings = stdout + _without_notices(stderr)
        failed = bool(linter.returncode or findings.strip())
        print(f'{name}: {"failed" if failed else "passed"}\n{findings}', end='', flush=True)
        counts += Counts(not failed, failed, 0)
    return counts


def _without_notices(text):
    """Drop what catkin_lint says about a rosdep that is not installed."""
    return ''.join(line for line in text.splitlines(keepends=True) if 'rosdep' not in line
                   and 'unknown dependencies' not in line)


def _existing_test(name):
    if not list(TESTS.glob(f'*/{_file_name(name)}')):
        raise argparse.ArgumentTypeError(f'there is no test {name!r}; see the folder test')
    return name


def _file_name(name):
    return name if name.endswith('.test') else f'{Path(name).stem}.py'


def _run_tests(names):
    shutil.rmtree(RESULTS, ignore_errors=True)
    for command in map(_command, names) if names else [_make('run_tests')]:
        subprocess.run(command, check=False)
    files = sorted(RESULTS.rglob('*.xml'))
    return sum((_count(file) for file in files), Counts(0, 0, 0))


def _command(name):
    """Return the command that runs the tests of one file."""
    stem = Path(name).stem
    if name.endswith('.test'):
        return _make(f'run_tests_odometry_tests_rostest_rostests_{stem}.test')
    file, = TESTS.glob(f'*/{_file_name(name)}')
    return ['python3', '-m', 'pytest', '-q', file, f'--junitxml={RESULTS / stem}.xml']


def _make(target):
    return ['catkin_make', '-C', str(WORKSPACE), '--no-color', f'-j{JOBS}', target]


def _count(file):
    """Count a JUnit file, and print what failed or was skipped in it."""
    cases = ElementTree.parse(file).getroot().iter('testcase')
    counts = Counts(0, 0, 0)
    for case in cases:
        failed = case.find('failure') is not None or case.find('error') is not None
        skipped = case.find('skipped')
        counts += Counts(not failed and skipped is None, failed, skipped is not None)
        if failed:
            print(f'FAILED {case.get("classname")} {case.get("name")}')
        elif skipped is not None:
            print(f'skipped {case.get("classname")} {case.get("name")}: {skipped.get("message")}')
    if file.stem.startswith('rostest-'):
        # That a test script has run is no test of its own; that it has not is a failure.
        return counts._replace(passed=0)
    return counts


if __name__ == '__main__':
    main()
