"""A C++ client in lockstep with a loop of ros::Rate, a clock of 100 Hz, beside a ring of bare nodes."""

import tempfile
from pathlib import Path

from graph import FINE_LOCKSTEP, Graph
from measuring import SPEED_UNIT, Target
from odometry_tests.lockstep_runs import compile_client
from ring_speed import beside_ring

# 6 times real time where the ring makes 159
NAME, UNIT, TARGET = 'C++ client in lockstep', SPEED_UNIT, Target('>=', 0.038)


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        client = compile_client(Path(folder, 'client')), 'rate'
        return beside_ring(options, Graph(*FINE_LOCKSTEP, client=client))
