"""Folders for output and logs."""

import atexit
import contextlib
import itertools
import os
import shutil
import tempfile
import time
from pathlib import Path

import rospkg

from odometry_tools.runs.output import complain

CLONE = Path(__file__).resolve().parents[5]
LOG_SIZE = 2**16  # bytes; the logs of a run are not much larger


def find_runs():
    """Return the folder of all output: runs in the clone, if this user can write there."""
    runs = CLONE / 'runs'
    is_writable = os.access(runs if runs.exists() else CLONE, os.W_OK)
    return runs if is_writable else Path(rospkg.get_ros_home()) / 'odometry_runs'


RUNS = Path(os.environ.get('ODOMETRY_RUNS') or find_runs())


def new_folder(name=''):
    """Make a new folder in RUNS, named by the time; several may start in the same second."""
    name += time.strftime('%Y-%m-%d_%H-%M-%S')
    RUNS.mkdir(parents=True, exist_ok=True)
    for number in itertools.count(1):
        folder = RUNS / (name if number == 1 else f'{name}_{number}')
        with contextlib.suppress(FileExistsError):
            folder.mkdir()
            return folder


@contextlib.contextmanager
def path_in_errors(path):
    """Yield a path that is being written, and add it to an OSError, since write() does not."""
    try:
        yield path
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None


def use_writable_logs(folder=None):
    """If ROS cannot write its home or its logs, use another folder; report one for logs.

    :param folder: to use then; None: a new temporary one
    """
    failed = {variable: error for variable, path in (
        ('ROS_HOME', rospkg.get_ros_home()), ('ROS_LOG_DIR', rospkg.get_log_dir()))
        if (error := _error_of_writing(path))}
    if failed:
        if folder is None:
            folder = tempfile.mkdtemp(prefix='ros-')
            if 'ROS_LOG_DIR' not in failed:
                atexit.register(shutil.rmtree, folder, ignore_errors=True)
        os.environ.update({variable: folder for variable in failed}, MPLCONFIGDIR=folder)
    if 'ROS_LOG_DIR' in failed:
        complain(f'logs are in {folder}: {failed["ROS_LOG_DIR"]}')


def _error_of_writing(folder):
    """Make a folder and write as much as logs may need; return the error, or None."""
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as file:
            file.write(bytes(LOG_SIZE))
            file.flush()
    except OSError as error:
        return error
    return None
