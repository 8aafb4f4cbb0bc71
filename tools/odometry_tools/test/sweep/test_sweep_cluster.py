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
LOCAL = ['--host', '127.0.0.1', '--no-dashboard']


def ws(*arguments, **options):
    return Process(ROOT / 'ws', *arguments, **options)


def rows_below(folder):
    """Return the lines of the sweep in a folder so far, without the heading."""
    return [line for file in folder.glob('sweep-*/runs.csv') for line in file.read_text().splitlines()[1:]]


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


@pytest.fixture
def start_sweep(scheduler, tmp_path):
    """Return a function that starts a sweep of so many runs, which writes into tmp_path."""
    return lambda runs: ws('sweep', *CAMPAIGN, str(runs), '--cluster', scheduler.address,
                           env={'ODOMETRY_RUNS': str(tmp_path)})


@pytest.mark.nightly
def test_a_worker_is_killed_and_no_row_is_lost_or_there_twice(workers, start_sweep, tmp_path):
    killed, other = workers
    with start_sweep(RUNS) as run:
        wait_until(lambda: len(rows_below(tmp_path)) >= SOME, TIMEOUT, lambda: run.output)
        killed.send(signal.SIGKILL)
        assert len(rows_below(tmp_path)) < RUNS, 'too late'
        assert run.wait(TIMEOUT) == 0, run.output
    assert killed.wait() == 128 + signal.SIGKILL and other.running
    alone = folder_of(sweep(*CAMPAIGN, str(RUNS)).stdout)
    assert rows_below(tmp_path) == (alone / 'runs.csv').read_text().splitlines()[1:]
    assert len(rows_below(tmp_path)) == RUNS


@pytest.mark.nightly
@pytest.mark.usefixtures('workers')
def test_a_scheduler_that_is_killed_ends_the_sweep_with_one_line(scheduler, start_sweep, tmp_path):
    with start_sweep(MANY) as run:
        wait_until(lambda: rows_below(tmp_path), TIMEOUT, lambda: run.output)
        scheduler.send(signal.SIGKILL)
        assert run.wait(TIMEOUT) == 1, run.output
    found = re.fullmatch(rf'sweep: the scheduler of the cluster is gone after (\d+) of {MANY} runs, '
                         r'which are in \S+', run.stderr)
    assert found and len(rows_below(tmp_path)) == int(found[1]) > 0, run.stderr


@pytest.mark.parametrize('address', [
    pytest.param('tcp://127.0.0.1:1', marks=pytest.mark.nightly), 'nonsense'])
def test_no_scheduler_is_one_line(address):
    run = sweep('move', '--cluster', address, status=2)
    assert re.fullmatch(f'sweep: no scheduler answers at {address}: .*', run.stderr), run.stderr


@pytest.mark.nightly
def test_a_cluster_without_workers_is_one_line(scheduler):
    run = sweep('move', '--cluster', scheduler.address, status=2)
    assert run.stderr == 'sweep: the cluster has no workers', run.output
