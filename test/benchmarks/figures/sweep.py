"""A thousand drives by ./ws sweep on two processors, beside PyBullet stepping as many."""

import time

from measuring import Target, in_turns
from odometry_sweep.closed_loop import run
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from worlds import BareWorld

DRIVES = 1000
NAME, UNIT, TARGET = f'{DRIVES} drives on two processors', 's', Target('<=', 1.3)
PACE_WINDOW = 5.0  # s after each; the machine is not as fast in each second
TIMEOUT = 300.0  # s


def measure(options):
    bare, simulated = BareWorld(), run('move', {})['time']
    return in_turns(options, _sweep, lambda: DRIVES * simulated / 2 / bare.speed(PACE_WINDOW))


def _sweep():
    begin = time.perf_counter()
    with Process(ROOT / 'ws', 'sweep', 'move', '--seeds', DRIVES, '--jobs', 2) as process:
        assert process.wait(TIMEOUT) == 0, process.output
    return time.perf_counter() - begin
