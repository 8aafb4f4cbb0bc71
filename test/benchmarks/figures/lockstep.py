"""Robot, detector and mover in lockstep, beside a ring of bare nodes that pass the same messages on.

The nodes of the ring step PyBullet, publish and answer, and do nothing else.
"""

from graph import LOCKSTEP, Graph
from measuring import SPEED_UNIT, Target
from ring_speed import beside_ring

NAME, UNIT, TARGET = 'graph in lockstep', SPEED_UNIT, Target('>=', 0.35)


def measure(options):
    return beside_ring(options, Graph(*LOCKSTEP))
