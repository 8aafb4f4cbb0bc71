"""Do the runs of a campaign in parallel, on this machine or on a Dask cluster."""

import collections
import concurrent.futures
import contextlib
import itertools
import logging
import multiprocessing
import multiprocessing.util
import os
import signal

from odometry_common.parameters import StartError
from sim_turtlebot.physics.world_file import WorldFileError

from odometry_tools.runs.output import RunError
from odometry_tools.sweep.closed_loop import run

MAX_AHEAD = 1000  # runs that may be done before an earlier one
CHECK_PERIOD = 1.0  # s
CONNECT_TIMEOUT = 10  # s
TRIAL = 'rotate', {'target': 5, 'odometry_source': 'encoder', 'wheel_noise': 0.001}


def run_all(campaign, executor, is_lost, killed):
    """Yield parameters and metrics of each run of a Campaign, in order.

    Every CHECK_PERIOD without one, yield None.

    :param is_lost: function that returns whether no more runs can be done
    :param killed: the executor's exception when a process that did runs was killed
    :raises RunError: if a run cannot be done, or the processes are lost
    """
    begun = ((parameters, executor.submit(campaign.subject.run, parameters))
             for parameters in campaign.runs())
    try:
        ahead = collections.deque(itertools.islice(begun, MAX_AHEAD))
        while ahead:
            parameters, future = ahead[0]
            # Dask does not wake result() if the scheduler is gone.
            if not concurrent.futures.wait([future], CHECK_PERIOD).done:
                if is_lost():
                    raise concurrent.futures.CancelledError
                yield None
                continue
            yield parameters, future.result()
            ahead.popleft()
            ahead.extend(itertools.islice(begun, 1))
    except killed:
        raise RunError('a process that did runs was killed') from None
    except concurrent.futures.CancelledError:
        raise RunError('the scheduler of the cluster is gone') from None
    except WorldFileError as error:
        raise RunError(f'{parameters["world"]} must be {error}') from None


@contextlib.contextmanager
def on_this_machine(campaign, jobs=None):
    """Yield an executor with this many processes, and what else run_all() takes.

    :param jobs: number of processes; None: as many as suit the campaign's subject
    """
    usual = campaign.subject.jobs_per_processor * len(os.sched_getaffinity(0))
    processes = min(jobs or usual, campaign.count)
    multiprocessing.util.get_temp_dir()  # for all: a process that is killed would leave its own
    # A forked process has imported everything.
    with concurrent.futures.ProcessPoolExecutor(
            processes, multiprocessing.get_context('fork'), _reset_signals) as executor:
        try:
            yield executor, lambda: False, concurrent.futures.BrokenExecutor
        except BaseException:
            for process in multiprocessing.active_children():
                process.kill()  # a run may take minutes
            raise


def _reset_signals():
    """Restore the default signal handlers in a forked process."""
    for signum in (signal.SIGINT, signal.SIGTERM):
        signal.signal(signum, signal.SIG_DFL)


@contextlib.contextmanager
def on_cluster(address):
    """Yield an executor of the cluster, and what else run_all() takes.

    Without its scheduler Dask cancels the futures that it knows, but fails if something is
    submitted meanwhile.

    :param address: of the scheduler, tcp://HOST:PORT
    :raises StartError: if the cluster is not usable
    """
    import distributed
    logging.disable()  # Dask logs what its exceptions say
    try:
        client = distributed.Client(address, timeout=CONNECT_TIMEOUT)
    except (OSError, ValueError) as error:
        raise StartError(f'no scheduler answers at {address}: {error}') from None
    with _closing(client):
        try:
            client.wait_for_workers(1, timeout=CONNECT_TIMEOUT)
            results = client.run(run, *TRIAL)
        except (TimeoutError, distributed.TimeoutError):  # Python 3.10 has two
            raise StartError('the cluster has no workers') from None
        except ImportError as error:
            raise StartError(f'a worker was not started by ./ws dask worker: {error}') from None
        expected = run(*TRIAL)
        for worker, metrics in results.items():
            if metrics != expected:  # in the last digits
                raise StartError(f'the worker {worker} has another version of these packages')
        yield (client.get_executor(), lambda: client.status != 'running',
               distributed.KilledWorker)


@contextlib.contextmanager
def _closing(client):
    """Close a client at the end, though its thread may have failed as the scheduler went."""
    try:
        yield
    finally:
        with contextlib.suppress(RuntimeError):
            client.close()
