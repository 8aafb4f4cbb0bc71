"""Where ROS writes its logs."""

import os
import tempfile

import rospkg

from odometry_launch.output import complain

LOG_SIZE = 2**16  # bytes; the logs of a run are not much larger


def use_writable_logs():
    """Let ROS log to a new temporary folder, and say so, if it cannot write its usual one."""
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
