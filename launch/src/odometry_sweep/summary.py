"""The runs of a setting in a few numbers."""

import numpy

from odometry_sweep.closed_loop import ARRIVED

STATISTICS = {'median': 50, 'p5': 5, 'p95': 95, 'worst': None}  # percentiles


class Setting:
    """The runs that differ in their seeds only."""

    def __init__(self, name, rows):
        """Take its name, for the user, and the figures of each run."""
        self.name = name
        self.runs = len(rows)
        self.not_arrived = sum(row['ended'] != ARRIVED for row in rows)
        self._rows = rows

    @property
    def all_equal(self):
        """Whether several runs came out the same: nothing in them is random."""
        return self.runs > 1 and all(row == self._rows[0] for row in self._rows)

    def values(self, figure):
        """Return a figure of all runs as an array."""
        return numpy.array([row[figure] for row in self._rows])

    def statistic(self, figure, name):
        """Return a statistic; the worst is what is farthest from zero."""
        return _statistic(self.values(figure), name)

    def size(self, figure, name):
        """Return the same of the figure's size, whatever its sign."""
        return _statistic(abs(self.values(figure)), name)


def _statistic(values, name):
    if name == 'worst':
        return float(values[abs(values).argmax()])
    return float(numpy.percentile(values, STATISTICS[name]))
