"""The runs of a campaign, side by side on this machine or on a Dask cluster."""

import concurrent.futures
import contextlib
import logging

from odometry_common.parameters import StartError

from odometry_sweep.closed_loop import run

MOST_JOBS = 2  # for each processor; more would only take memory
CONNECT_TIMEOUT = 10  # s
TRIAL = 'rotate', {'target': 5, 'odometry_source': 'encoder', 'wheel_noise': 0.001}


class LostError(RuntimeError):
    """A process or machine that did runs is gone; the message is one line for the user."""


@contextlib.contextmanager
def side_by_side(jobs=None, cluster=None):
    """Yield a function that yields parameters and metrics of each run of a Campaign, in order.

    :param jobs: number of processes, at most MOST_JOBS for each processor and one for each run;
        None: one for each processor
    :param cluster: address of a Dask scheduler whose workers do the runs; None: this machine does
    :raises StartError: if that is not possible
    :raises LostError: if it is no longer possible, between two runs
    """
    import joblib
    processors = joblib.cpu_count()
    most = min(jobs or processors, MOST_JOBS * processors)

    def run_all(campaign):
        parallel = joblib.Parallel(n_jobs=-1 if cluster else min(most, campaign.count),
                                   return_as='generator')
        results = parallel(joblib.delayed(run)(campaign.tutorial, parameters)
                           for parameters in campaign.runs())
        try:
            yield from zip(campaign.runs(), results)
        except concurrent.futures.BrokenExecutor:
            raise LostError('a process that did runs was killed') from None
        except concurrent.futures.CancelledError:
            raise LostError('the scheduler of the cluster is gone') from None

    with _on_cluster(cluster) if cluster else contextlib.nullcontext():
        yield run_all


@contextlib.contextmanager
def _on_cluster(address):
    """Have joblib run on the cluster whose scheduler is at an address, tcp://HOST:PORT."""
    import distributed
    import joblib
    logging.disable()  # Dask's own messages; ours are exceptions
    try:
        client = distributed.Client(address, timeout=CONNECT_TIMEOUT)
    except (OSError, ValueError) as error:
        raise StartError(f'no scheduler answers at {address}: {error}') from None
    with client, joblib.parallel_config(backend='dask'):
        _check_workers(client)
        yield


def _check_workers(client):
    """Have each worker do a short run: another version of anything shows in the last digits."""
    try:
        client.wait_for_workers(1, timeout=CONNECT_TIMEOUT)
        results = client.run(run, *TRIAL)
    except TimeoutError:
        raise StartError('the cluster has no workers') from None
    except ImportError as error:
        raise StartError(f'a worker was not started by ./ws dask worker: {error}') from None
    expected = run(*TRIAL)
    for worker, metrics in results.items():
        if metrics != expected:
            raise StartError(f'the worker {worker} has another version of these packages')
