"""The metrics of the runs: file, statistics, table, and limits."""

import csv
from typing import NamedTuple

import numpy
import yaml

from odometry_tools.runs.folders import path_in_errors
from odometry_tools.runs.tutorials import ARRIVED

FILE = 'runs.csv'
CAMPAIGN_FILE = 'campaign.yaml'
UNTIL = 'until'  # why a run of nodes that go on for ever ended
NOT_ARRIVED, ENDS = 'not_arrived', (ARRIVED, UNTIL)  # how a run ends well
# Units of each run's metrics; error = actual - target.
METRICS = {
    'move': {
        'moved': 'm',
        'moved_error': 'm',
        'true_distance': 'm',
        'true_error': 'm',
        'sideways': 'm',
        'heading': 'degrees',
        'time': 's'},
    'rotate': {
        'heading': 'degrees',
        'heading_error': 'degrees',
        'true_heading': 'degrees',
        'true_error': 'degrees',
        'overshoot': 'degrees',
        'time': 's'},
    'launch': {
        'distance': 'm',
        'from_start': 'm',
        'sideways': 'm',
        'heading': 'degrees',
        'heading_error': 'degrees',
        'odometry_error': 'm',
        'time': 's',
        'commands': 'messages'}}
# In table and picture.
SHOWN = {
    'move': ['moved_error', 'true_error', 'sideways', 'heading', 'time'],
    'rotate': ['heading_error', 'true_error', 'overshoot', 'time'],
    'launch': ['from_start', 'sideways', 'heading', 'odometry_error', 'time']}
STATISTICS = {'median': 'median', 'p5': '5 %', 'p95': '95 %', 'worst': 'worst'}  # headings by name
DECIMALS = {'m': 4, 'degrees': 3, 's': 2, 'messages': 0}


class Combination(NamedTuple):
    """The runs of a combination of parameter values, which differ only in their seeds."""

    name: str
    rows: list  # metrics of each run, by name

    def values(self, metric):
        """Return a metric of all runs, or whether they did not arrive, as an array."""
        return numpy.array([row['ended'] not in ENDS if metric == NOT_ARRIVED else row[metric]
                            for row in self.rows])

    def why(self, run):
        """Return why the nodes of the run with this index ended badly, after a colon, or ''."""
        reason = self.rows[run].get('why')
        return f': {reason}' if reason else ''

    def size_of(self, limit):
        """Return what a limit bounds, in words and as a number, and the index of the worst run."""
        if limit == NOT_ARRIVED:
            late = self.values(NOT_ARRIVED)
            return limit, late.sum(), int(late.argmax())
        metric, _, name = limit.rpartition('_')
        sizes = abs(self.values(metric))
        return f'|{metric}|_{name}', statistics(sizes)[name], int(sizes.argmax())


def statistics(values):
    """Return the STATISTICS of an array by name; the worst is farthest from zero."""
    median, low, high = numpy.quantile(values, [0.5, 0.05, 0.95])
    return dict(zip(STATISTICS, [median, low, high, values[abs(values).argmax()]]))


def table(kind, combinations):
    """Return a block for each metric, with a line for each Combination."""
    titles = {metric: f'{metric} ({METRICS[kind][metric]})' for metric in SHOWN[kind]}
    names = [combination.name for combination in combinations]
    width = max(map(len, [*titles.values(), *names]))
    blocks = []
    for metric, title in titles.items():
        decimals = DECIMALS[METRICS[kind][metric]]
        lines = [_line(title, width, STATISTICS.values())]
        for combination in combinations:
            figures = statistics(combination.values(metric)).values()
            # Adding zero prevents -0.0.
            lines.append(_line(combination.name, width, [
                f'{round(value, decimals) + 0.0:.{decimals}f}' for value in figures]))
        blocks.append('\n'.join(lines))
    return '\n\n'.join(blocks)


def _line(name, width, cells):
    return f'{name:{width}}' + ''.join(f'{cell:>10}' for cell in cells)


def write_results(folder, campaign, runs):
    """Write a campaign and its runs, as run_all() yields them, to a folder; yield their metrics."""
    columns = [*campaign.values, 'seed', *METRICS[campaign.subject.kind], 'ended']
    content = {**campaign.subject._asdict(), 'seeds': campaign.seeds,
               'set': campaign.values, 'limits': campaign.limits}
    with path_in_errors(folder / CAMPAIGN_FILE) as path:
        path.write_text(yaml.safe_dump(content, sort_keys=False))
    _append(folder / FILE, ['run', *columns])
    for number, (parameters, metrics) in enumerate(runs, 1):
        values = {**parameters, **metrics}
        _append(folder / FILE, [number, *(values[column] for column in columns)])
        yield metrics


def _append(path, row):
    with path_in_errors(path), open(path, 'a', newline='', encoding='utf-8') as file:
        csv.writer(file, lineterminator='\n').writerow(row)
