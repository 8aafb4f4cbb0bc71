"""Folders for the output and the logs of demos and sweeps."""

import contextlib
import itertools
import os
import tempfile
import time
from pathlib import Path

import rospkg

from odometry_launch.output import complain

RUNS = Path(os.environ.get('ODOMETRY_RUNS') or Path(__file__).resolve().parents[3] / 'runs')
LOG_SIZE = 2**16  # bytes; the logs of a run are not much larger


def new_folder(name=''):
    """Make a folder of this name and moment in RUNS; several may start in the same second."""
    name += time.strftime('%Y-%m-%d_%H-%M-%S')
    for number in itertools.count(1):
        folder = RUNS / (name if number == 1 else f'{name}_{number}')
        with contextlib.suppress(FileExistsError):
            folder.mkdir(parents=True)
            return folder


@contextlib.contextmanager
def path_in_errors(path):
    """Yield a path that is being written to, and name it in an OSError: write() does not."""
    try:
        yield path
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None


def use_writable_logs():
    """If ROS cannot write its usual log folder, make it log to a new temporary one, and say so."""
    try:
        os.makedirs(rospkg.get_log_dir(), exist_ok=True)
        for folder in (rospkg.get_log_dir(), rospkg.get_ros_home()):
            with tempfile.TemporaryFile(dir=folder) as file:
                file.write(bytes(LOG_SIZE))
                file.flush()
    except OSError as error:
        folder = tempfile.mkdtemp(prefix='ros-')
        complain(f'logs are in {folder}: {error}')
        os.environ.update(ROS_HOME=folder, ROS_LOG_DIR=folder, MPLCONFIGDIR=folder)
