"""A pytest plugin: which files ./ws test runs, on how many workers, and the line that it closes with."""

import os
from pathlib import Path

import pytest

from odometry_tests.scripts import TESTS

WORKERS_PER_PROCESSOR = 3  # most tests wait most of the time, for each other's processes
BY_DAY = 'not nightly'  # of pytest.ini
OUTCOMES = {'passed': ['passed'], 'failed': ['failed', 'error'], 'skipped': ['skipped']}


def pytest_configure(config):
    """Keep the order of pytest.ini, and take a file by its name alone: test_drive, detector.test."""
    choose_tests(config)
    config.option.loadscopereorder = False  # those that take longest come first already
    config.args = [_path_of(argument, config.rootpath) for argument in config.args]


def choose_tests(config):
    """Run named files whole, with their nightly tests; at night, try new random sequences, too."""
    by_day = config.option.markexpr == BY_DAY
    config.option.hypothesis_profile = 'ci' if by_day else 'nightly'
    if by_day and not has_folder(config) and '-m' not in config.invocation_params.args:
        config.option.markexpr = ''


def has_folder(config):
    return any(Path(argument).is_dir() for argument in config.args)


def _path_of(argument, root):
    name, *case = argument.split('::')
    if Path(name).exists():
        return argument
    found = [path for pattern in (f'{name}.py', name) for folder in TESTS
             for path in root.glob(f'{folder}/**/{pattern}')]
    if not found:
        raise pytest.UsageError(f'there is no test {name}')
    return '::'.join([str(found[0]), *case])


def pytest_xdist_auto_num_workers(config):
    """Start so many workers for `-n auto`, and no more than there are files to run."""
    workers = WORKERS_PER_PROCESSOR * len(os.sched_getaffinity(0))
    return workers if has_folder(config) else min(workers, len(config.args))


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config):
    reporter = config.pluginmanager.get_plugin('terminalreporter')
    if reporter and not hasattr(config, 'workerinput') and not config.option.collectonly:
        counts = [f'{sum(len(reporter.stats.get(key, [])) for key in keys)} {word}'
                  for word, keys in OUTCOMES.items()]
        reporter.write_line(', '.join(counts))
