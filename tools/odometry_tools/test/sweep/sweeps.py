"""Sweeps as a user types them, and what they leave."""

import csv
import os
import re
import sys
from pathlib import Path

from odometry_tests.processes import run
from odometry_tests.scripts import ROOT

TIMEOUT = 120.0  # s
WS, SCRIPT = (ROOT / 'ws', 'sweep'), (sys.executable, ROOT / 'tools' / 'odometry_tools' / 'script' / 'sweep.py')


def sweep(*arguments, command=WS, timeout=TIMEOUT, **options):
    return run(*command, *arguments, cwd=ROOT, timeout=timeout, **options)


def folder_of(output):
    return Path(os.environ['ODOMETRY_RUNS'], re.search(r'sweep-[-\w]+', output)[0])


def rows_in(folder):
    with open(folder / 'runs.csv', newline='', encoding='utf-8') as file:
        return list(csv.DictReader(file))
