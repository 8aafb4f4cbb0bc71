"""Where ROS writes its logs."""

import contextlib
import os
import signal
import sys
import tempfile

import rospkg

from odometry_launch.output import complain

ENOUGH = bytes(2**16)  # a run's logs are not much larger


@contextlib.contextmanager
def place_for_logs():
    """Provide one for this context: the usual place, or, with a line, a folder that goes with it."""
    refusal = _refusal()
    if not refusal:
        yield
        return
    signal.signal(signal.SIGTERM, _end)
    with tempfile.TemporaryDirectory(prefix='ros-') as place:
        complain(f'until the end logs are in {place}: {refusal}')
        for name in ('ROS_HOME', 'ROS_LOG_DIR', 'MPLCONFIGDIR'):
            os.environ[name] = place
        yield


def _refusal():
    """Return why logs cannot be written as usual, or None."""
    try:
        os.makedirs(rospkg.get_log_dir(), exist_ok=True)
        for folder in (rospkg.get_log_dir(), rospkg.get_ros_home()):
            with tempfile.TemporaryFile(dir=folder) as file:
                file.write(ENOUGH)
                file.flush()
    except OSError as error:
        return error
    return None


def _end(signum, _frame):
    signal.signal(signum, signal.SIG_IGN)  # it comes again where the nodes take long to end
    sys.exit(128 + signum)
