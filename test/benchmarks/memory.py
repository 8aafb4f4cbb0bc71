"""Whether memory stays what it was."""

from graph import Graph
from measuring import Target, compare
from speed import UNPACED

MINUTE = 60.0  # s


def memory(options):
    """Measure all processes after many simulated minutes; the limit is what one minute needs."""
    pairs = [_memory(options.minutes) for _ in range(options.runs)]
    yield compare(f'memory after {options.minutes} simulated minutes', 'MB', pairs,
                  Target('<=', 1.01))


def _memory(minutes):
    """Return the memory late and early (MB) in one run."""
    with Graph(*UNPACED) as graph:
        graph.run_until(MINUTE, 0.01)
        early = graph.memory()
        graph.run_until(minutes * MINUTE, 0.2)
        return graph.memory(), early
