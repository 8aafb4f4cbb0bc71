"""The runs of a campaign, side by side."""

import concurrent.futures
import contextlib
import importlib

from odometry_common.parameters import StartError

from odometry_sweep.closed_loop import run
from odometry_sweep.cluster import on_cluster

MOST_JOBS = 2  # for each processor; more of them would only take memory


class LostError(RuntimeError):
    """Whoever did the runs is gone; the message is one line for the user."""


@contextlib.contextmanager
def side_by_side(jobs=None, cluster=None):
    """Yield a function that yields parameters and figures of each run of a Campaign, in order.

    :param jobs: so many processes, but at most MOST_JOBS for each processor and one for each run;
        None: one for each processor
    :param cluster: address of a Dask scheduler whose workers do the runs; None: this machine does
    :raises StartError: if that is not possible
    :raises LostError: if it is no longer, between two runs that are yielded
    """
    joblib = _installed('joblib')
    processors = joblib.cpu_count()
    most = min(jobs or processors, MOST_JOBS * processors)

    def run_all(campaign):
        parallel = joblib.Parallel(n_jobs=-1 if cluster else min(most, campaign.count),
                                   return_as='generator')
        return zip(campaign.runs(), _until_lost(parallel(
            joblib.delayed(run)(campaign.tutorial, parameters) for parameters in campaign.runs())))

    with on_cluster(cluster, _installed('distributed')) if cluster else contextlib.nullcontext():
        yield run_all


def _until_lost(results):
    try:
        yield from results
    except concurrent.futures.BrokenExecutor:
        raise LostError('a process that did runs was killed') from None
    except concurrent.futures.CancelledError:
        raise LostError('the scheduler of the cluster is gone') from None


def _installed(name):
    """Return a module that only sweeps need."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise StartError(f'{name} is not installed: ./ws does that; elsewhere, '
                         f'pip install {name}') from None
