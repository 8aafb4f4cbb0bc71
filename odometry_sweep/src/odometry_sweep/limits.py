"""Say which limits of a campaign its runs exceed, to the user and to CI."""

import re
import subprocess
import sys

from odometry_launch import junit
from odometry_launch.output import complain

PROGRAM = 'sweep'


def check(campaign, combinations, folder, report=None):
    """Print a line for each limit that a Combination exceeds; return whether there is one.

    The worst run of each such limit is repeated, which leaves its bag and its picture.

    :param folder: of the sweep
    :param report: path of a file for CI
    """
    lines, worst = {limit: [] for limit in campaign.limits}, {}
    for index, combination in enumerate(combinations):
        for exceeded in combination.exceeded(campaign.limits):
            complain(exceeded.line, PROGRAM)
            lines[exceeded.limit].append(exceeded.line)
            worst.setdefault(exceeded.limit, index * campaign.seeds + exceeded.worst + 1)
    if report:
        junit.write(report, 'odometry_sweep', [
            junit.Case(campaign.name, limit, '; '.join(found), 'limit') for limit, found in lines.items()])
    for number in dict.fromkeys(worst.values()):
        _record(folder, number)
    if lines and not worst:
        print(f'limits          all {len(lines)} hold', flush=True)
    return bool(worst)


def _record(folder, number):
    """Repeat a run, and print where its picture is, beside its bag; a process is a node only once."""
    replay = subprocess.run([sys.executable, sys.argv[0], '--replay', str(folder), str(number)],
                            capture_output=True, text=True, check=False)
    if found := re.search('^picture +(.*)$', replay.stdout, re.MULTILINE):
        print(f'run {number:<12}{found[1]}', flush=True)
    else:
        complain(f'run {number} is not recorded: {replay.stderr.strip()}', PROGRAM)
