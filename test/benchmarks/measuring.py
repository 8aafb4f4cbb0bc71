"""How a figure is measured: in turns with its limit, so that a noisy moment hits both."""

import operator
from statistics import median
from typing import NamedTuple

SLICES = 4  # of a window
RELATIONS = {'>=': operator.ge, '<=': operator.le, '=': operator.eq}


class Target(NamedTuple):
    """What a figure should be."""

    relation: str  # a key of RELATIONS
    bound: float
    of_value: bool = False  # the value is meant, not its ratio to the limit

    def __str__(self):
        """Return it as a table shows it."""
        return f'{"value " if self.of_value else ""}{self.relation} {self.bound:g}'


class Figure(NamedTuple):
    """A measured value beside its limit; the medians of several runs."""

    name: str
    value: float
    unit: str
    limit: float
    ratio: float  # the median of value / limit run by run; not a number if the limit is zero
    target: Target = None

    @property
    def misses(self):
        """Whether it is not what it should be."""
        if self.target is None:
            return False
        seen = self.value if self.target.of_value else self.ratio
        return not RELATIONS[self.target.relation](seen, self.target.bound)


class Options(NamedTuple):
    """How thoroughly to measure."""

    runs: int
    window: float  # s of wall time in which something is watched
    messages: int  # whose latency is measured in one run, at most
    longest: int  # s of wall time for them
    minutes: int  # of simulated time for the memory


def in_turns(runs, measure, measure_limit):
    """Measure value and limit in turns and return the pairs.

    :param measure, measure_limit: functions without arguments
    """
    return [(measure(), measure_limit()) for _ in range(runs)]


def in_slices(options, measure, measure_limit):
    """Measure value and limit in turns, for a slice of the window each, and return the pairs.

    A slow moment of the machine lasts longer than a slice, and so hits both.

    :param measure, measure_limit: functions of the s of wall time in which to watch
    """
    slice_ = options.window / SLICES
    return in_turns(SLICES * options.runs, lambda: measure(slice_), lambda: measure_limit(slice_))


def compare(name, unit, pairs, target=None):
    """Return the Figure of pairs (value, limit)."""
    ratios = [value / limit if limit else float('nan') for value, limit in pairs]
    return Figure(name, median(value for value, _ in pairs), unit,
                  median(limit for _, limit in pairs), median(ratios), target)
