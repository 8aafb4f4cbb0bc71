"""What there is to run: test files, linters, and the commands for them."""

import argparse
import os
import sys
from pathlib import Path
from typing import NamedTuple

import rospkg

# A link without a space where the path has one, which rostest cannot bear.
ROOT = Path(os.environ['ODOMETRY_ROOT'])
TESTS = ROOT / 'test'
RESULTS = ROOT / '.ws' / 'test_results'
EXAMPLE = ROOT / 'docs' / 'example'  # which catkin does not find by itself
LAUNCH_FILES = ['sim.launch', 'move_two_meters.launch', 'rotate.launch']
# They begin first, so that no processor idles at the end.
LONGEST = ['test_container', 'test_documents', 'unit', 'test_demo_faults', 'test_sweep',
           'test_sweep_replay', 'test_endings', 'test_lockstep', 'test_sweep_cluster',
           'test_tutorial_commands', 'test_soak', 'test_example', 'test_demo_endings',
           'test_fault_kills', 'test_bad_parameters', 'test_demo_page', 'test_bench',
           'test_ros_tools', 'turtlebot.test', 'test_fault_time', 'test_set_up', 'test_demo',
           'simulator.test', 'test_loopback', 'test_two_machines', 'test_placing',
           'test_fault_minute', 'test_set_up_again', 'test_page_nonsense', 'test_plot_run',
           'test_view_start', 'robots.test', 'test_browser_robots', 'test_browser']


class Job(NamedTuple):
    """A command that runs tests, in a process of its own."""

    name: str
    command: list
    is_linter: bool = False  # one test, passed if the command exits with 0
    draws: bool = False  # which keeps a processor busy
    starts_master: bool = False  # as roslaunch does, which may give up

    @property
    def results(self):
        """Where its JUnit files are."""
        return RESULTS / self.name.replace('::', '-').replace('/', '-')


def all_jobs():
    """Return a job for each test file and linter, the longest first.

    Unit tests share one process.
    """
    files = _test_files()
    jobs = [_pytest('unit', TESTS / 'unit')]
    jobs += [_job(name) for name, file in files.items()
             if file.parent.name in ('system', 'screen', 'rostests', 'test')]
    jobs.sort(key=lambda job: LONGEST.index(job.name) if job.name in LONGEST else len(LONGEST))
    return [*jobs, *(Job(name, command, is_linter=True) for name, command in _linters().items())]


def job(name):
    """Return the job with a name: test_drive, test_drive::test_x, detector.test, unit, ruff.

    :raises argparse.ArgumentTypeError: if there is none
    """
    linters = _linters()
    if name in linters:
        return Job(name, linters[name], is_linter=True)
    if name in ('unit', 'system', 'screen'):
        return _pytest(name, TESTS / name)
    if name.partition('::')[0] not in _test_files():
        raise argparse.ArgumentTypeError(
            f'there is no test {name!r}; see the folder test for their names')
    return _job(name)


def _test_files():
    """Return the test files by name."""
    pytests = [*TESTS.glob('*/test_*.py'), *ROOT.glob('*/test/test_*.py')]
    return {**{file.stem: file for file in sorted(pytests)},
            **{file.name: file for file in sorted(TESTS.glob('rostests/*.test'))}}


def _job(name):
    name_of_file, separator, case = name.partition('::')
    file = _test_files()[name_of_file]
    if file.suffix == '.py':
        return _pytest(name, f'{file}{separator}{case}')
    made = Job(name, ['rostest', '--results-filename', f'{file.stem}.xml', '--results-base-dir'])
    return made._replace(command=[*made.command, made.results, 'odometry_tests', file.name],
                         starts_master=True)


def _pytest(name, path):
    command = [sys.executable, '-m', 'pytest', '-q', '--color=no', '--tb=short',
               '-p', 'no:cacheprovider', str(path)]
    kind = Path(path).parent.name
    if kind in ('system', 'screen'):
        # Only unit tests need hypothesis, which takes pytest a second to load.
        command += ['-p', 'no:hypothesispytest']
    made = Job(name, command, draws=kind == 'screen')
    return made._replace(command=[*command, f'--junitxml={made.results / "pytest.xml"}'])


def _linters():
    check = Path(rospkg.RosPack().get_path('roslaunch'), 'scripts', 'roslaunch-check')
    checks = {f'roslaunch-check-{name}': [
        str(check), '-o', str(RESULTS / f'{name}.xml'), str(ROOT / 'launch' / name)]
        for name in LAUNCH_FILES}
    # What a newer Python brings, such as itertools.pairwise, is not there on Ubuntu 20.04.
    vermin = ['vermin', '--quiet', '--no-tips', '--violations', '--target=3.8-', str(ROOT)]
    return {'ruff': ['ruff', 'check', '--quiet', str(ROOT)], 'vermin': vermin,
            'catkin_lint': ['catkin_lint', '--quiet', '--strict', str(ROOT), str(EXAMPLE)],
            **checks}
