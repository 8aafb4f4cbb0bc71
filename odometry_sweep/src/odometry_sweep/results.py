"""The metrics of the runs: file, statistics, table, and limits."""

import csv
from typing import NamedTuple

import numpy
from odometry_launch.folders import path_in_errors

from odometry_sweep.closed_loop import ARRIVED, UNTIL

FILE = 'runs.csv'
CAMPAIGN_FILE = 'campaign.yaml'
NOT_ARRIVED = 'not_arrived'
# Units of each run's metrics; error = actual - target.
METRICS = {
    'move': {'moved': 'm', 'moved_error': 'm', 'true_distance': 'm', 'true_error': 'm',
             'sideways': 'm', 'heading': 'degrees', 'time': 's'},
    'rotate': {'heading': 'degrees', 'heading_error': 'degrees', 'true_heading': 'degrees',
               'true_error': 'degrees', 'overshoot': 'degrees', 'time': 's'},
    'launch': {'distance': 'm', 'from_start': 'm', 'sideways': 'm', 'heading': 'degrees',
               'heading_error': 'degrees', 'odometry_error': 'm', 'time': 's', 'commands': 'messages'}}
# In table and picture.
SHOWN = {'move': ['moved_error', 'true_error', 'sideways', 'heading', 'time'],
         'rotate': ['heading_error', 'true_error', 'overshoot', 'time'],
         'launch': ['from_start', 'sideways', 'heading', 'odometry_error', 'time']}
STATISTICS = {'median': 0.5, 'p5': 0.05, 'p95': 0.95, 'worst': None}  # quantiles
HEADINGS = ['median', '5 %', '95 %', 'worst']
DECIMALS = {'m': 4, 'degrees': 3, 's': 2, 'messages': 0}
COLUMN = 10  # characters


class Exceeded(NamedTuple):
    """A limit that a Combination exceeds."""

    limit: str
    line: str  # for the user
    worst: int  # index of the worst run


class Combination(NamedTuple):
    """The runs of a combination of parameter values, which differ only in their seeds."""

    name: str
    rows: list  # metrics of each run, by name

    @property
    def not_arrived(self):
        """The number of runs that did not arrive."""
        return sum(self.is_late)

    @property
    def is_late(self):
        """Whether each run did not arrive."""
        return [row['ended'] not in (ARRIVED, UNTIL) for row in self.rows]

    @property
    def all_equal(self):
        """Whether several runs have the same result, since nothing in them is random."""
        return len(self.rows) > 1 and all(row == self.rows[0] for row in self.rows)

    def values(self, metric):
        """Return a metric of all runs as an array."""
        return numpy.array([row[metric] for row in self.rows])

    def exceeded(self, limits):
        """Yield an Exceeded for each limit (a number by name) that the size of a metric exceeds."""
        for limit, most in limits.items():
            metric, _, name = limit.rpartition('_')
            sizes = self.is_late if limit == NOT_ARRIVED else abs(self.values(metric))
            value = self.not_arrived if limit == NOT_ARRIVED else statistic(sizes, name)
            if not value <= most:
                yield Exceeded(limit, f'{limit} is {value:.6g}, over its limit of {most:g}, with {self.name}',
                               int(numpy.argmax(sizes)))


def statistic(values, name):
    """Return one of STATISTICS of an array; the worst is farthest from zero."""
    if name == 'worst':
        return float(values[abs(values).argmax()])
    return float(numpy.quantile(values, STATISTICS[name]))


def table(tutorial, combinations):
    """Return a block for each metric, with a line for each Combination."""
    units = METRICS[tutorial]
    titles = {metric: f'{metric} ({units[metric]})' for metric in SHOWN[tutorial]}
    width = max(map(len, [*titles.values(), *(combination.name for combination in combinations)]))
    blocks = []
    for metric, title in titles.items():
        lines = [_line(title.ljust(width), HEADINGS)]
        for combination in combinations:
            values, decimals = combination.values(metric), DECIMALS[units[metric]]
            lines.append(_line(combination.name.ljust(width), (
                f'{round(statistic(values, name), decimals) + 0.0:.{decimals}f}'  # no -0.0
                for name in STATISTICS)))
        blocks.append('\n'.join(lines))
    return '\n\n'.join(blocks)


def _line(begin, cells):
    return begin + ''.join(cell.rjust(COLUMN) for cell in cells)


def write_results(folder, campaign, runs):
    """Write a campaign and its runs into a folder, each when it is done; yield their metrics.

    :param runs: yields parameters and metrics of each run, by name
    """
    columns = [*campaign.values, 'seed', *METRICS[campaign.tutorial], 'ended']
    with path_in_errors(folder / CAMPAIGN_FILE) as path:
        path.write_text(campaign.text(), encoding='utf-8')
    _append(folder / FILE, ['run', *columns])
    for number, (parameters, metrics) in enumerate(runs, 1):
        values = {**parameters, **metrics}
        _append(folder / FILE, [number, *(values[column] for column in columns)])
        yield metrics


def _append(path, row):
    with path_in_errors(path), open(path, 'a', newline='', encoding='utf-8') as file:
        csv.writer(file, lineterminator='\n').writerow(row)


def read_rows(folder):
    """Return the rows of a folder, as dictionaries of strings; none without a file."""
    if not (folder / FILE).exists():
        return []
    with open(folder / FILE, newline='', encoding='utf-8') as file:
        return list(csv.DictReader(file))
