"""What a node's process needs before it starts: output, open files, logs."""

import logging
import os
import resource
import sys
import tempfile

import rospkg


def open_output():
    """Print each line at once; without a terminal, Python buffers output until the node exits."""
    for name in 'stdout', 'stderr':
        if getattr(sys, name) is None:  # closed by the parent process
            setattr(sys, name, open(os.devnull, 'w', encoding='ascii'))  # noqa: SIM115
        getattr(sys, name).reconfigure(line_buffering=True)


def raise_limit_on_files():
    """Raise the soft limit on open files to the hard limit: rospy opens one for each connection."""
    _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))


def go_without_logs_if_necessary():
    """Run without logs where they cannot be written.

    rospy exits with a traceback if it cannot open its log file, but only warns if the folder is
    missing. On a full disk, logging would print tracebacks.
    """
    logging.raiseExceptions = False
    folder = rospkg.get_log_dir()
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError:
        os.environ['ROS_LOG_DIR'] = os.path.join(os.devnull, 'log')
