"""A client in lockstep that drives by tf in a loop, with a clock of 100 Hz, beside real time."""

import sys

from graph import FINE_LOCKSTEP, UNDER_WAY, Graph
from measuring import SPEED_UNIT, Target, in_slices
from odometry_tests.lockstep_runs import CLIENTS_FOLDER
from odometry_tests.processes import Process

NAME, UNIT, TARGET = 'tf client in lockstep', SPEED_UNIT, Target('>=', 25)


def measure(options):
    """Return pairs of a speed and 1."""
    with Graph(*FINE_LOCKSTEP, movers=False) as graph, \
            Process(sys.executable, CLIENTS_FOLDER / 'clients.py', 'tf_listener'):
        graph.run_until(UNDER_WAY)
        return in_slices(options, graph.speed, lambda _: 1.0)
