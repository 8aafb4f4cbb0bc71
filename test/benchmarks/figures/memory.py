"""Memory of all processes after ten simulated minutes, beside that after one."""

from graph import UNPACED, Graph
from measuring import Target

NAME, UNIT, TARGET = 'memory after 10 simulated minutes', 'MB', Target('<=', 1.01)


def measure(options):
    return [_late_and_early() for _ in range(options.runs)]


def _late_and_early():
    with Graph(*UNPACED) as graph:
        graph.run_until(60.0)
        early = graph.memory()
        graph.run_until(600.0)
        return graph.memory(), early
