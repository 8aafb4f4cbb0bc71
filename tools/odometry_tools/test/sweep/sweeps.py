"""Sweeps as a user types them, and what they leave."""

import os
import re
import sys
from functools import partial
from pathlib import Path

from odometry_tests.forms import rows_of
from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

TIMEOUT = 120.0  # s
WS, SCRIPT = (ROOT / 'ws', 'sweep'), (sys.executable, ROOT / 'tools/odometry_tools/script/sweep.py')


sweep = partial(run, *WS, cwd=ROOT, timeout=TIMEOUT)
sweep_by_script = partial(run, *SCRIPT, cwd=ROOT, timeout=TIMEOUT)  # ./ws knows only its own packages


def folder_of(output):
    return Path(os.environ['ODOMETRY_RUNS'], re.search(r'sweep-[-\w]+', output)[0])


def rows_in(folder):
    return rows_of(folder / 'runs.csv')
