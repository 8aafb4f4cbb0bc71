"""A sweep on a Dask cluster gives the rows that this machine gives, also if a worker is killed."""

import contextlib
import os
import re
import signal
from pathlib import Path

import pytest
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until
from sweeps import TIMEOUT, folder_of, sweep

RUNS, MANY, SOME = 150, 100000, 10
CAMPAIGN = ['move', '--set', 'distance=0.4321', '--set', 'odometry_source=encoder',
            '--set', 'wheel_noise=0.01', '--seeds']
LOCAL = ['--host', '127.0.0.1', '--no-dashboard']


def ws(*arguments):
    return Process(ROOT / 'ws', *arguments)


def lines_in(folder):
    return (folder / 'runs.csv').read_text().splitlines()[1:]


def folders():
    files = Path(os.environ['ODOMETRY_RUNS']).glob('sweep-*/runs.csv')
    return {file.parent for file in files if lines_in(file.parent)}


@pytest.fixture
def scheduler():
    with hold_port() as port, ws('dask', 'scheduler', *LOCAL, '--port', str(port)) as process:
        process.wait_for_output('Scheduler at', TIMEOUT)
        process.address = f'tcp://127.0.0.1:{port}'
        yield process


@pytest.fixture
def workers(scheduler):
    with contextlib.ExitStack() as stack:
        processes = [stack.enter_context(ws('dask', 'worker', scheduler.address, *LOCAL,
                                            '--nthreads', '1', '--no-nanny')) for _ in range(2)]
        for process in processes:
            process.wait_for_output('Registered to', TIMEOUT)
        yield processes


@contextlib.contextmanager
def sweeping(scheduler, runs):
    before = folders()
    with ws('sweep', *CAMPAIGN, str(runs), '--cluster', scheduler.address) as run:
        folder, = wait_until(lambda: folders() - before, TIMEOUT, 'the folder of the sweep')
        yield run, folder


@pytest.mark.nightly
def test_a_worker_is_killed_and_no_row_is_lost_or_there_twice(scheduler, workers):
    killed, other = workers
    with sweeping(scheduler, RUNS) as (run, folder):
        wait_until(lambda: len(lines_in(folder)) >= SOME, TIMEOUT, f'{SOME} rows')
        killed.send(signal.SIGKILL)
        assert len(lines_in(folder)) < RUNS, 'too late'
        assert run.wait(TIMEOUT) == 0, run.output
    assert killed.wait() == 128 + signal.SIGKILL and other.running
    rows = lines_in(folder_of(sweep(*CAMPAIGN, str(RUNS)).stdout))
    assert lines_in(folder) == rows and len(rows) == RUNS


@pytest.mark.nightly
@pytest.mark.usefixtures('workers')
def test_a_scheduler_that_is_killed_ends_the_sweep_with_one_line(scheduler):
    with sweeping(scheduler, MANY) as (run, folder):
        scheduler.send(signal.SIGKILL)
        assert run.wait(TIMEOUT) == 1, run.output
    found = re.fullmatch(rf'sweep: the scheduler of the cluster is gone after (\d+) of {MANY} runs, '
                         r'which are in \S+', run.stderr)
    assert found and len(lines_in(folder)) == int(found[1]) > 0, run.stderr


@pytest.mark.parametrize('address', [
    pytest.param('tcp://127.0.0.1:1', marks=pytest.mark.nightly), 'nonsense'])
def test_no_scheduler_is_one_line(address):
    run = sweep('move', '--cluster', address, status=2)
    assert re.fullmatch(f'sweep: no scheduler answers at {address}: .*', run.stderr), run.stderr


@pytest.mark.nightly
def test_a_cluster_without_workers_is_one_line(scheduler):
    run = sweep('move', '--cluster', scheduler.address, status=2)
    assert run.stderr == 'sweep: the cluster has no workers', run.output
