"""How a figure is measured: in turns with its limit, so that a noisy moment hits both."""

import operator
from statistics import median
from typing import NamedTuple

SPEED_UNIT = 'simulated s/s'
SLICES = 4  # of a window
RELATIONS = {'>=': operator.ge, '<=': operator.le}


class Options(NamedTuple):
    """How thoroughly to measure."""

    runs: int
    window: float  # s of wall time in which something is watched


class Target(NamedTuple):
    """What a figure should be."""

    relation: str  # a key of RELATIONS
    bound: float  # of the ratio to the limit

    def __str__(self):
        """Return it as a table shows it."""
        return f'{self.relation} {self.bound:g}'


class Figure(NamedTuple):
    """A measured value beside its limit; the medians of several runs."""

    name: str
    value: float
    unit: str
    limit: float
    ratio: float  # the median of value / limit, run by run
    target: Target

    @classmethod
    def of(cls, module, options):
        """Measure what a module in the folder `figures` measures."""
        pairs = module.measure(options)
        return cls(module.NAME, median(value for value, _ in pairs), module.UNIT,
                   median(limit for _, limit in pairs),
                   median(value / limit for value, limit in pairs),
                   module.TARGET)

    @property
    def is_missed(self):
        """Whether it is not what it should be."""
        return not RELATIONS[self.target.relation](self.ratio, self.target.bound)


def in_turns(options, measure, measure_limit):
    """Measure value and limit in turns and return the pairs.

    :param measure, measure_limit: functions without arguments
    """
    return [(measure(), measure_limit()) for _ in range(options.runs)]


def in_slices(options, measure, measure_limit):
    """Measure value and limit in turns, for a slice of the window each, and return the pairs.

    A slow moment of the machine lasts longer than a slice, and so hits both.

    :param measure, measure_limit: functions of the s of wall time in which to watch
    """
    slice_ = options.window / SLICES
    return [(measure(slice_), measure_limit(slice_)) for _ in range(SLICES * options.runs)]
