"""A sweep on a Dask cluster gives the rows that this machine gives, also if a worker is killed."""

import contextlib
import re
import signal

import pytest
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until

TIMEOUT = 90.0  # s
RUNS, MANY = 150, 100000
NOBODY_ELSE_HAS = '0.4321'  # m, by which the sweep's folder is found while it runs
CAMPAIGN = ['move', '--set', f'distance={NOBODY_ELSE_HAS}', '--set', 'odometry_source=encoder',
            '--set', 'wheel_noise=0.01', '--seeds']
SOME = 10


def ws(*arguments):
    """Start a command by ./ws."""
    return Process(ROOT / 'ws', *arguments)


def lines_in(folder):
    """Return the lines of the rows that a sweep has written so far."""
    return (folder / 'runs.csv').read_text().splitlines()[1:]


def new_folder(before):
    """Return the folder of our sweep, None as long as there is none."""
    for folder in set(ROOT.glob('runs/sweep-*')) - before:
        with contextlib.suppress(FileNotFoundError):
            if NOBODY_ELSE_HAS in (folder / 'campaign.yaml').read_text() and lines_in(folder):
                return folder
    return None


@pytest.fixture
def scheduler():
    """Start a Dask scheduler and return its process, with its address."""
    with hold_port() as port, ws('dask', 'scheduler', '--host', '127.0.0.1', '--port', str(port),
                                 '--no-dashboard') as process:
        process.wait_for_output('Scheduler at', TIMEOUT)
        process.address = f'tcp://127.0.0.1:{port}'
        yield process


def worker(address):
    """Start a worker that nobody starts again."""
    return ws('dask', 'worker', address, '--host', '127.0.0.1', '--nthreads', '1', '--no-nanny',
              '--no-dashboard')


def test_a_worker_is_killed_and_no_row_is_lost_or_there_twice(scheduler):
    """In the middle of the sweep; the other one does the rest."""
    before = set(ROOT.glob('runs/sweep-*'))
    with worker(scheduler.address) as one, worker(scheduler.address) as other:
        for process in one, other:
            process.wait_for_output('Registered to', TIMEOUT)
        with ws('sweep', *CAMPAIGN, str(RUNS), '--cluster', scheduler.address) as run:
            folder = wait_until(lambda: new_folder(before), TIMEOUT, 'the folder of the sweep')
            wait_until(lambda: len(lines_in(folder)) >= SOME, TIMEOUT, f'{SOME} rows')
            one.send(signal.SIGKILL)
            assert len(lines_in(folder)) < RUNS, 'too late'
            assert run.wait(TIMEOUT) == 0, run.output
        assert one.wait() == -signal.SIGKILL and other.running
    alone = ws('sweep', *CAMPAIGN, str(RUNS))
    assert alone.wait(TIMEOUT) == 0, alone.output
    rows = lines_in(ROOT / re.search(r'runs/sweep-[-\w]+', alone.stdout)[0])
    assert lines_in(folder) == rows and len(rows) == RUNS


def test_a_scheduler_that_is_killed_ends_the_sweep_with_one_line(scheduler):
    """What is done is kept."""
    before = set(ROOT.glob('runs/sweep-*'))
    with worker(scheduler.address) as one, worker(scheduler.address) as other:
        for process in one, other:
            process.wait_for_output('Registered to', TIMEOUT)
        with ws('sweep', *CAMPAIGN, str(MANY), '--cluster', scheduler.address) as run:
            folder = wait_until(lambda: new_folder(before), TIMEOUT, 'the folder of the sweep')
            scheduler.send(signal.SIGKILL)
            assert run.wait(TIMEOUT) == 1, run.output
    found = re.fullmatch(rf'sweep: the scheduler of the cluster is gone after (\d+) of {MANY} runs, '
                         r'which are in \S+', run.stderr)
    assert found and len(lines_in(folder)) == int(found[1]) > 0, run.stderr


@pytest.mark.parametrize('address', ['tcp://127.0.0.1:1', 'nonsense', 'tcp://', 'ftp://host:1'])
def test_no_scheduler_is_one_line(address):
    """And exit status 2."""
    run = ws('sweep', 'move', '--cluster', address)
    assert run.wait(TIMEOUT) == 2, run.output
    assert run.stderr.startswith(f'sweep: no scheduler answers at {address}: '), run.stderr
    assert len(run.stderr.splitlines()) == 1, run.stderr


def test_a_cluster_without_workers_is_one_line(scheduler):
    """After a while: they may be starting."""
    run = ws('sweep', 'move', '--cluster', scheduler.address)
    assert run.wait(TIMEOUT) == 2, run.output
    assert run.stderr == 'sweep: the cluster has no workers', run.stderr
