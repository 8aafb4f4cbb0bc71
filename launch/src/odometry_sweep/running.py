"""The runs of a campaign, side by side."""

import concurrent.futures
import contextlib
import importlib

from odometry_common.parameters import StartError

from odometry_sweep.closed_loop import run
from odometry_sweep.cluster import on_cluster


class LostError(RuntimeError):
    """Whoever did the runs is gone; the message is one line for the user."""


@contextlib.contextmanager
def side_by_side(jobs=None, cluster=None):
    """Yield a function that yields parameters and figures of each run of a Campaign, in order.

    :param jobs: so many processes; None: one for each processor
    :param cluster: address of a Dask scheduler whose workers do the runs; None: this machine does
    :raises StartError: if that is not possible
    :raises LostError: if it is no longer, between two runs that are yielded
    """
    joblib = _installed('joblib')
    with on_cluster(cluster, _installed('distributed')) if cluster else contextlib.nullcontext():
        run_all = joblib.Parallel(n_jobs=jobs or -1, return_as='generator')
        yield lambda campaign: zip(campaign.runs(), _until_lost(run_all(
            joblib.delayed(run)(campaign.tutorial, parameters) for parameters in campaign.runs())))


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
