"""A C++ client in lockstep with a loop of ros::Rate, with a clock of 100 Hz, beside real time."""

import tempfile
from pathlib import Path

from graph import FINE_LOCKSTEP, UNDER_WAY, Graph
from measuring import SPEED_UNIT, Target, in_slices
from odometry_tests.lockstep_runs import compile_client
from odometry_tests.processes import Process

NAME, UNIT, TARGET = 'C++ client in lockstep', SPEED_UNIT, Target('>=', 6)


def measure(options):
    """Return pairs of a speed and 1."""
    with tempfile.TemporaryDirectory() as folder, Graph(*FINE_LOCKSTEP, movers=False) as graph, \
            Process(compile_client(Path(folder, 'client')), 'rate'):
        graph.run_until(UNDER_WAY)
        return in_slices(options, graph.speed, lambda _: 1.0)
