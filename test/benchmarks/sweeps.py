"""How fast a sweep is, beside PyBullet stepping and nothing else."""

import re
import time
from pathlib import Path

from joblib.externals.loky import get_reusable_executor
from measuring import Figure, Target, compare, in_slices, in_turns
from odometry_sweep.campaign import Campaign
from odometry_sweep.closed_loop import run
from odometry_sweep.running import side_by_side
from odometry_tests.processes import Process
from speed import SPEED_UNIT
from worlds import BareWorld

ROOT = Path(__file__).resolve().parents[2]
MANY = 1000  # drives
FEW = 30  # drives, in which two processors are compared with one
PACE_WINDOW = 5.0  # s, before and after them; the machine is not as fast in each second
TIMEOUT = 300.0  # s


def sweep(options):
    """Measure the loop in one process, two of them, a thousand drives, and a run once more."""
    bare = BareWorld()
    _run()  # connects and builds the world
    yield compare('loop in one process', SPEED_UNIT,
                  in_slices(options, _loop_speed, bare.speed), Target('>=', 0.85))
    with side_by_side(jobs=2) as on_two, side_by_side(jobs=1) as on_one:
        _runs_per_second(on_two)  # starts the processes
        yield compare('sweep on two processors', 'runs/s', in_turns(
            options.runs, lambda: _runs_per_second(on_two), lambda: _runs_per_second(on_one)),
            Target('>=', 1.7))
    get_reusable_executor().shutdown()
    yield from _thousand(bare)


def _thousand(bare):
    """Return the figures of a whole ./ws sweep, and of one of its runs by the nodes themselves."""
    before = bare.speed(PACE_WINDOW)
    begin = time.perf_counter()
    with Process(ROOT / 'ws', 'sweep', 'move', '--seeds', MANY, '--jobs', 2) as process:
        assert process.wait(TIMEOUT) == 0, process.output
    duration = time.perf_counter() - begin
    pace = (before + bare.speed(PACE_WINDOW)) / 2
    folder = ROOT / re.search(r'^figures +(.*)/', process.stdout, re.MULTILINE).group(1)
    limit = MANY * _run()['time'] / 2 / pace
    yield Figure(f'{MANY} drives on two processors', duration, 's', limit, duration / limit,
                 Target('<=', 1.3))
    with Process(ROOT / 'ws', 'sweep', '--replay', folder, MANY) as replay:
        yield Figure('runs that differ from their replay', replay.wait(TIMEOUT), '', 0.0,
                     float('nan'), Target('=', 0, of_value=True))


def _run():
    return run('move', {})


def _loop_speed(window):
    """Return the simulated seconds per second of drives (s of wall time)."""
    simulated, start = 0.0, time.perf_counter()
    while (duration := time.perf_counter() - start) < window:
        simulated += _run()['time']
    return simulated / duration


def _runs_per_second(run_all):
    start = time.perf_counter()
    drives = list(run_all(Campaign('move', FEW, {}, {})))
    return len(drives) / (time.perf_counter() - start)
