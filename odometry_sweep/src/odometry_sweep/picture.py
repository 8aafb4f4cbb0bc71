"""A picture with the distributions of the metrics of a sweep."""

import numpy
from odometry_launch.figure import new_figure

from odometry_sweep.results import METRICS, SHOWN

FILE = 'distributions.png'
BINS = 30
BAR_HEIGHT = 0.85  # of the highest bar; 1: the distance between two combinations
WIDTH, ROW, FRAME = 2.2, 0.7, 1.5  # inches: of a diagram, of a combination, of titles and axes
MIN_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # on a shorter axis noise looks large
MAX_HEIGHT = 60.0  # inches


def make_figure(tutorial, combinations):
    """Return a figure with a diagram for each metric, and in it a histogram per Combination."""
    metrics = SHOWN[tutorial]
    figure = new_figure(WIDTH * len(metrics), min(MAX_HEIGHT, FRAME + ROW * len(combinations)))
    diagrams = figure.subplots(1, len(metrics), sharey=True)
    for metric, axes in zip(metrics, diagrams):
        unit = METRICS[tutorial][metric]
        _draw(axes, [combination.values(metric) for combination in combinations], MIN_SPANS[unit])
        axes.set(title=metric.replace('_', ' '), xlabel=unit)
        axes.grid(True, axis='x')
    diagrams[0].set_yticks(range(len(combinations)), [combination.name for combination in combinations])
    diagrams[0].invert_yaxis()
    figure.legend(handles=diagrams[0].lines[:1], loc='outside lower left', frameon=False)
    figure.suptitle(f'{tutorial}, {sum(len(combination.rows) for combination in combinations)} runs')
    return figure


def _draw(axes, rows, span):
    """Draw a histogram above the line of each row of values, and mark its median.

    :param span: minimum length of the axis
    """
    values = numpy.concatenate(rows)
    more = max(0.0, span - numpy.ptp(values)) / 2
    edges = numpy.histogram_bin_edges(values, BINS, (values.min() - more, values.max() + more))
    for place, values in enumerate(rows):
        counts, _ = numpy.histogram(values, edges)
        axes.stairs(place - BAR_HEIGHT * counts / counts.max(), edges, baseline=place, fill=True)
        axes.plot([numpy.median(values)] * 2, [place, place - BAR_HEIGHT], color='black', label='median')
        axes.axhline(place, color='grey', linewidth=0.5)
    axes.ticklabel_format(axis='x', useOffset=False, style='plain')
    axes.locator_params(axis='x', nbins=3)
