"""Child processes that end with the process that started them, even if it is killed."""

import subprocess
import sys

from odometry_tests.scripts import ROOT

REAPER = ROOT / 'tools/setup/reaper.py'


def start_guarded(*command, **popen_options):
    """Start a command that ends, with everything it has started, when it or this process ends.

    It runs in a new session, with an empty standard input.

    :return: the subprocess.Popen of its reaper, which ends with the status that a shell shows of the
        command, once everything has ended; its terminate() starts that, and returns at once
    """
    return subprocess.Popen(
        ['setpriv', '--pdeathsig', 'TERM', sys.executable, '-I', '-S', REAPER, *map(str, command)],
        stdin=subprocess.DEVNULL, start_new_session=True, **popen_options)
