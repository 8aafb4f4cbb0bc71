"""Where ROS writes its logs."""

import os
import tempfile

import rospkg

from odometry_launch.output import complain

ENOUGH = bytes(2**16)  # a run's logs are not much larger


def find_place_for_logs():
    """Write logs elsewhere, and say so in a line, if they cannot be written as usual."""
    try:
        os.makedirs(rospkg.get_log_dir(), exist_ok=True)
        for folder in (rospkg.get_log_dir(), rospkg.get_ros_home()):
            with tempfile.TemporaryFile(dir=folder) as file:
                file.write(ENOUGH)
                file.flush()
    except OSError as error:
        place = tempfile.mkdtemp(prefix='ros-')
        complain(f'logs are in {place}: {error}')
        for name in ('ROS_HOME', 'ROS_LOG_DIR', 'MPLCONFIGDIR'):
            os.environ[name] = place
