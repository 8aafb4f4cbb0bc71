"""The runs of a campaign, side by side."""

from odometry_sweep.closed_loop import run


def run_all(campaign, jobs=None):
    """Yield the parameters and the figures of each run, in their order.

    :param jobs: so many processes; None: one for each processor
    """
    from joblib import Parallel, delayed  # is installed when the first sweep is asked for
    run_side_by_side = Parallel(n_jobs=jobs or -1, return_as='generator')
    yield from zip(campaign.runs(), run_side_by_side(
        delayed(run)(campaign.tutorial, parameters) for parameters in campaign.runs()))
