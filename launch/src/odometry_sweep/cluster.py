"""The runs of a campaign on the workers of a Dask cluster."""

import contextlib
import logging

from odometry_common.parameters import StartError

from odometry_sweep.closed_loop import run

CONNECT_TIMEOUT = 10  # s
TRIAL = 'rotate', {'target': 5, 'odometry_source': 'encoder', 'wheel_noise': 0.001}


@contextlib.contextmanager
def on_cluster(address, distributed):
    """Have joblib run on the cluster whose scheduler is at an address, tcp://HOST:PORT.

    :param distributed: Dask's module
    :raises StartError: if there is none, or if a worker would give other figures
    """
    import joblib
    logging.disable()  # Dask's own; what matters to the user is raised
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
        figures = client.run(run, *TRIAL)
    except TimeoutError:
        raise StartError('the cluster has no workers') from None
    except ImportError as error:
        raise StartError(f'a worker was not started by ./ws dask worker: {error}') from None
    expected = run(*TRIAL)
    for worker, found in figures.items():
        if found != expected:
            raise StartError(f'the worker {worker} has another version of these packages')
