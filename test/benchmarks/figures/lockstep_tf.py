"""A client in lockstep that drives by tf in a loop, with a clock of 100 Hz, beside a ring of bare nodes."""

import sys

from graph import FINE_LOCKSTEP, Graph
from measuring import SPEED_UNIT, Target
from odometry_tests.lockstep_runs import CLIENTS_FOLDER
from ring_speed import beside_ring

# 25 times real time where the ring makes 159
NAME, UNIT, TARGET = 'tf client in lockstep', SPEED_UNIT, Target('>=', 0.157)


def measure(options):
    client = sys.executable, CLIENTS_FOLDER / 'clients.py', 'tf_listener'
    return beside_ring(options, Graph(*FINE_LOCKSTEP, client=client))
