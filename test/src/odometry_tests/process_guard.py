"""Child processes that end with the process that started them, even if it is killed."""

import subprocess
import sys

from odometry_tests.scripts import ROOT

REAPER = ROOT / 'launch' / 'src' / 'odometry_launch' / 'reaper.py'


def start_guarded(*command, **popen_options):
    """Start a command that ends, with everything it has started, when it or this process ends.

    It runs in a new session, with an empty standard input.

    :return: the subprocess.Popen of its reaper, which ends as the command has ended, once everything
        has; its terminate() starts to end everything, and returns at once
    """
    # Nobody writes into this pipe. The reaper reads until it ends, with this process.
    return subprocess.Popen([sys.executable, '-I', '-S', REAPER, *map(str, command)],
                            stdin=subprocess.PIPE, start_new_session=True, **popen_options)
