"""A picture with the distributions of the metrics of a sweep."""

import numpy
from odometry_launch.figure import BLUE, DARK, new_figure, tidy

from odometry_sweep.results import METRICS, SHOWN

FILE = 'distributions.png'
BINS = 30
DIGITS = 6  # of a value; those after them are noise of rounding
FINE = 10  # steps of a grid in a bin; finer ones do not show
BAR_HEIGHT = 0.85  # of the highest bar; 1: the distance between two combinations
WIDTH, ROW, FRAME, MARGIN = 2.2, 0.7, 1.5, 1.5  # inches: a diagram, a combination, titles and axes, labels
MIN_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # on a shorter axis noise looks large
MAX_HEIGHT = 60.0  # inches


def make_figure(tutorial, combinations):
    """Return a figure with a diagram for each metric, and in it a histogram per Combination."""
    values = {metric: [combination.values(metric) for combination in combinations]
              for metric in SHOWN[tutorial]}
    # A diagram of a constant shows nothing.
    metrics = [metric for metric, rows in values.items()
               if numpy.ptp(numpy.concatenate(rows)).round(DIGITS)]
    metrics = metrics or SHOWN[tutorial][:1]
    figure = new_figure(MARGIN + WIDTH * len(metrics), min(MAX_HEIGHT, FRAME + ROW * len(combinations)),
                        layout='constrained')
    diagrams, = figure.subplots(1, len(metrics), sharey=True, squeeze=False)
    for metric, axes in zip(metrics, diagrams):
        unit = METRICS[tutorial][metric]
        _draw(axes, values[metric], MIN_SPANS[unit])
        axes.set_title(f'{metric.replace("_", " ")} ({unit})')
    tidy(*diagrams)
    diagrams[0].set_yticks(range(len(combinations)), [combination.name for combination in combinations])
    diagrams[0].invert_yaxis()
    figure.legend(handles=diagrams[0].lines[:1], loc='outside upper right', frameon=False)
    figure.suptitle(f'{tutorial}, {sum(len(combination.rows) for combination in combinations)} runs', color=DARK)
    return figure


def _draw(axes, rows, span):
    """Draw a histogram above the line of each row of values, and mark its median.

    :param span: minimum length of the axis
    """
    edges = _edges(numpy.concatenate(rows), span)
    for place, values in enumerate(rows):
        counts, _ = numpy.histogram(values, edges)
        axes.stairs(place - BAR_HEIGHT * counts / counts.max(), edges, baseline=place, fill=True, color=BLUE)
        axes.plot([numpy.median(values)] * 2, [place, place - BAR_HEIGHT], color=DARK, label='median')
        axes.axhline(place, color='grey', linewidth=0.5)
    axes.ticklabel_format(axis='x', useOffset=False, style='plain')
    axes.locator_params(axis='x', nbins=3)


def _edges(values, span):
    """Return the edges of the bins of a histogram of these values that is at least `span` wide.

    Values that lie on a grid, such as times, fall into the middles of bins, an equal number of steps each.
    """
    width = max(span, numpy.ptp(values)) / BINS
    step = numpy.diff(numpy.unique(values.round(DIGITS))).min(initial=span)
    if step > width / FINE:
        width = step * numpy.ceil(width / step)
    more = max(0.0, span - numpy.ptp(values)) / 2
    first = values.min() - width * (0.5 + numpy.ceil(more / width))
    return first + width * numpy.arange(numpy.ceil((values.max() + more - first) / width) + 1)
