"""What came out of a job, read from the JUnit files that it wrote."""

from typing import NamedTuple
from xml.etree import ElementTree


class Counts(NamedTuple):
    """How many tests ended in which way."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def __add__(self, other):
        """Return the sums."""
        return Counts(*map(sum, zip(self, other)))

    def __str__(self):
        """Return them in the words of the closing line."""
        return f'{self.passed} passed, {self.failed} failed, {self.skipped} skipped'


class Case(NamedTuple):
    """A test and how it ended."""

    file: str
    name: str
    seconds: float
    failure: str = None  # what it said
    skipped: str = None  # the reason

    @property
    def counts(self):
        """The Counts of this one test."""
        if self.failure is not None:
            return Counts(failed=1)
        return Counts(passed=1) if self.skipped is None else Counts(skipped=1)


def read_cases(job, status, output, seconds):
    """Return the Cases of a job that has ended.

    :param status: its exit status; one that no failed test explains counts as a failed test, so
        that a job which ended before its first test is not green
    :param output: what it printed, which is what there is to say in that case
    :param seconds: how long it took
    """
    cases = [case for file in sorted(job.results.rglob('*.xml')) for case in _read(job, file)]
    if job.is_linter and status == 0:
        return [Case(job.name, job.name, seconds)]
    unexplained = status != 0 and not any(case.failure is not None for case in cases)
    if unexplained or not cases:
        return [*cases, Case(job.name, job.name, seconds,
                             failure=f'{output.strip()}\nexit status {status}')]
    return cases


def _read(job, file):
    for case in ElementTree.parse(file).getroot().iter('testcase'):
        failure = case.find('failure') if case.find('failure') is not None else case.find('error')
        skipped = case.find('skipped')
        if failure is None and file.name.startswith('rostest-'):
            continue  # that a test script has run is no test of its own; that it has not is a failure
        yield Case(
            file=_file_of(case, job), name=case.get('name'), seconds=float(case.get('time') or 0.0),
            failure=None if failure is None else failure.text or failure.get('message') or '',
            skipped=None if skipped is None else skipped.get('message'))


def _file_of(case, job):
    """Return the name of the test file in a dotted name such as system.test_demo."""
    parts = (case.get('classname') or '').split('.')
    return next((part for part in parts if part.startswith('test_')), job.name)
