"""Run the linters and every test, and count what happened."""

import argparse
import os
import shutil
import signal
import sys
import time

from odometry_tests.waiting import PATIENCE
from report import Report
from results import read_cases
from running import load, run
from suite import RESULTS, all_jobs, job

# A test that hangs ends the tests of its process after half an hour, with what each thread does.
HANGS = f'-o faulthandler_timeout={450 * PATIENCE} -o faulthandler_exit_on_timeout=true'


def main():
    """Exit 0 only if something ran and nothing failed."""
    options = _parse()
    # Who starts a process in the background has it ignore Ctrl-C; the tests press it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for signum in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(signum, lambda signum, _: sys.exit(128 + signum))
    if options.nightly:
        os.environ['HYPOTHESIS_PROFILE'] = 'nightly'
    else:
        os.environ['PYTEST_ADDOPTS'] = HANGS
    if options.cpus:
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:options.cpus])
    try:
        with load(options.load):
            sys.exit(0 if _repeat(options) else 1)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)


def _repeat(options):
    """Run as often as asked for; stop at the first failure, and return whether there was none."""
    for number in range(1, options.repeat + 1):
        start = time.monotonic()
        report = _run(options.names or all_jobs())
        minutes, seconds = divmod(round(time.monotonic() - start), 60)
        if options.repeat > 1:
            print(f'run {number} of {options.repeat}: {minutes} min {seconds} s')
        print(report.counts, flush=True)
        if report.counts.failed or not report.counts.passed:
            return False
    return True


def _run(jobs):
    """Run jobs once and return the Report."""
    shutil.rmtree(RESULTS, ignore_errors=True)
    RESULTS.mkdir(parents=True)
    report = Report(len(jobs))
    processors = len(os.sched_getaffinity(0))
    for ended in run(jobs, processors, RESULTS, report.show_progress):
        cases = read_cases(ended.job, ended.status, ended.output, ended.seconds)
        report.add(cases, ended.seconds)
    report.close(RESULTS)
    return report


def _parse():
    parser = argparse.ArgumentParser(prog='./ws test', description=__doc__)
    parser.add_argument('names', nargs='*', metavar='NAME', type=job,
                        help='run only these, such as test_drive, test_drive::test_x, '
                             'detector.test, unit or ruff')
    parser.add_argument('--nightly', action='store_true',
                        help='try many more random sequences, new ones; takes hours')
    parser.add_argument('--repeat', type=_count, default=1, metavar='N',
                        help='run N times; stop at the first failure')
    parser.add_argument('--load', type=_count, default=0, metavar='K',
                        help='keep K processes busy meanwhile')
    parser.add_argument('--cpus', type=_count, default=None, metavar='N',
                        help='use N processors only')
    return parser.parse_args()


def _count(text):
    if not (text.isascii() and text.isdigit() and int(text) > 0):
        raise argparse.ArgumentTypeError(f'{text!r} is not a whole number above 0')
    return int(text)


if __name__ == '__main__':
    main()
