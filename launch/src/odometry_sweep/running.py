"""The runs of a campaign, side by side."""

import contextlib

from odometry_sweep.closed_loop import run
from odometry_sweep.cluster import on_cluster


@contextlib.contextmanager
def side_by_side(jobs=None, cluster=None):
    """Yield a function that yields parameters and figures of each run of a Campaign, in their order.

    :param jobs: so many processes; None: one for each processor
    :param cluster: address of a Dask scheduler whose workers do the runs; None: this machine does
    """
    from joblib import Parallel, delayed  # is installed when the first sweep is asked for
    with on_cluster(cluster) if cluster else contextlib.nullcontext():
        run_all = Parallel(n_jobs=jobs or -1, return_as='generator')
        yield lambda campaign: zip(campaign.runs(), run_all(
            delayed(run)(campaign.tutorial, parameters) for parameters in campaign.runs()))
