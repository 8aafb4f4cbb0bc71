"""A sweep on a Dask cluster gives the rows that this machine gives, also if a worker is killed."""

import contextlib
import re
import signal

import pytest
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until
from sweeps import TIMEOUT, folder_of, sweep

RUNS, MANY, SOME = 150, 100000, 10
CAMPAIGN = ['move', '--set', 'distance=0.4321', '--set', 'odometry_source=encoder',
            '--set', 'wheel_noise=0.01', '--seeds']


def rows_below(folder):
    """Return the lines of the sweep in a folder so far, without the heading."""
    return [line for file in folder.glob('sweep-*/runs.csv') for line in file.read_text().splitlines()[1:]]


@pytest.mark.nightly
def test_what_is_killed_loses_no_row_and_is_said_in_one_line(tmp_path):
    """Without workers; with one of two that is killed, after which no row is there twice; without a scheduler."""
    with hold_port() as port, contextlib.ExitStack() as stack:
        address = f'tcp://127.0.0.1:{port}'

        def start(name, runs):
            """Start a sweep of so many runs, which writes into a folder."""
            return Process(ROOT / 'ws', 'sweep', *CAMPAIGN, runs, '--cluster', address,
                           env={'ODOMETRY_RUNS': str(tmp_path / name)})

        def dask(*arguments):
            process = Process(ROOT / 'ws', 'dask', *arguments, '--host', '127.0.0.1', '--no-dashboard')
            return stack.enter_context(process)

        scheduler = dask('scheduler', '--port', port)
        scheduler.wait_for_output('Scheduler at', TIMEOUT)
        assert sweep('move', '--cluster', address, status=2).stderr == 'sweep: the cluster has no workers'
        killed, other = workers = [dask('worker', address, '--nthreads', '1', '--no-nanny') for _ in range(2)]
        for worker in workers:
            worker.wait_for_output('Registered to', TIMEOUT)
        with start('all', RUNS) as run:
            wait_until(lambda: len(rows_below(tmp_path / 'all')) >= SOME, TIMEOUT, lambda: run.output)
            killed.send(signal.SIGKILL)
            assert len(rows_below(tmp_path / 'all')) < RUNS, 'too late'
            assert run.wait(TIMEOUT) == 0, run.output
        assert killed.wait() == 128 + signal.SIGKILL and other.running
        with start('some', MANY) as run:
            wait_until(lambda: rows_below(tmp_path / 'some'), TIMEOUT, lambda: run.output)
            scheduler.send(signal.SIGKILL)
            assert run.wait(TIMEOUT) == 1, run.output
    alone = folder_of(sweep(*CAMPAIGN, RUNS).stdout)
    assert rows_below(tmp_path / 'all') == (alone / 'runs.csv').read_text().splitlines()[1:]
    found = re.fullmatch(rf'sweep: the scheduler of the cluster is gone after (\d+) of {MANY} runs, '
                         r'which are in \S+', run.stderr)
    assert found and len(rows_below(tmp_path / 'some')) == int(found[1]) > 0, run.stderr


def test_no_scheduler_is_one_line():
    run = sweep('move', '--cluster', 'nonsense', status=2)
    assert re.fullmatch('sweep: no scheduler answers at nonsense: .*', run.stderr), run.stderr
