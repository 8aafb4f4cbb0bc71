"""A picture of how the metrics of a sweep are distributed."""

import numpy
from odometry_launch.figure import new_figure

from odometry_sweep.results import METRICS, SHOWN

FILE = 'distributions.png'
BINS = 30
FULL = 0.85  # height of the highest bar; 1: the distance of two settings
WIDTH, ROW, FRAME = 2.2, 0.7, 1.5  # inches: of a diagram, of a setting, of titles and axes
SMALLEST_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # less is noise beside the other diagrams
HIGHEST = 60.0  # inches


def make_figure(tutorial, settings):
    """Return a figure with a diagram for each metric of the table, and a histogram per Setting."""
    metrics = SHOWN[tutorial]
    figure = new_figure(WIDTH * len(metrics), min(HIGHEST, FRAME + ROW * len(settings)))
    diagrams = figure.subplots(1, len(metrics), sharey=True)
    for metric, axes in zip(metrics, diagrams):
        unit = METRICS[tutorial][metric]
        _draw(axes, [setting.values(metric) for setting in settings], SMALLEST_SPANS[unit])
        axes.set(title=metric.replace('_', ' '), xlabel=unit)
        axes.grid(True, axis='x')
    diagrams[0].set_yticks(range(len(settings)), [setting.name for setting in settings])
    diagrams[0].invert_yaxis()
    figure.legend(handles=diagrams[0].lines[:1], loc='outside lower left', frameon=False)
    figure.suptitle(f'{tutorial}, {sum(len(setting.rows) for setting in settings)} runs')
    return figure


def _draw(axes, rows, span):
    """Draw a histogram above the line of each row of values, and mark its median.

    :param span: the shortest that the axis may be
    """
    values = numpy.concatenate(rows)
    more = max(0.0, span - numpy.ptp(values)) / 2
    edges = numpy.histogram_bin_edges(values, BINS, (values.min() - more, values.max() + more))
    for place, values in enumerate(rows):
        counts, _ = numpy.histogram(values, edges)
        axes.stairs(place - FULL * counts / counts.max(), edges, baseline=place, fill=True)
        axes.plot([numpy.median(values)] * 2, [place, place - FULL], color='black', label='median')
        axes.axhline(place, color='grey', linewidth=0.5)
    axes.ticklabel_format(axis='x', useOffset=False, style='plain')
    axes.locator_params(axis='x', nbins=3)
