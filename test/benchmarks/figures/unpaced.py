"""Robot, detector and mover as fast as they can, beside PyBullet alone."""

from graph import UNPACED, Graph
from measuring import SPEED_UNIT, Target, in_slices
from worlds import BareWorld

NAME, UNIT, TARGET = 'graph unpaced', SPEED_UNIT, Target('>=', 0.55)


def measure(options):
    with Graph(*UNPACED) as graph:
        return in_slices(options, graph.speed, BareWorld().speed)
