"""The table of figures, and two ways to measure a value and its limit."""

from typing import Callable, NamedTuple

SLICES = 4  # of a window


class Figure(NamedTuple):
    """What is measured, and what its ratio to its limit should be."""

    title: str
    unit: str
    relation: str  # >= or <=
    bound: float
    measure: Callable


FIGURES = {}


def figure(title, unit, relation, bound):
    """Decorate the function that measures a figure; `./ws bench` takes its name."""
    def add(measure):
        FIGURES[measure.__name__] = Figure(title, unit, relation, bound, measure)
        return measure
    return add


def in_turns(options, measure, measure_limit):
    """Measure value and limit in turns, so that a noisy moment hits both; return the pairs."""
    return [(measure(), measure_limit()) for _ in range(options.runs)]


def in_slices(options, measure, measure_limit):
    """Measure value and limit in turns, for a slice of the window each, and return the pairs.

    A slow moment of the machine lasts longer than a slice, and so hits both.

    :param measure, measure_limit: functions of the s of wall time in which to watch
    """
    slice_ = options.window / SLICES
    return [(measure(slice_), measure_limit(slice_)) for _ in range(SLICES * options.runs)]
