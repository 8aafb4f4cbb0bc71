"""A picture of how the metrics of a sweep are distributed."""

import numpy
from run_plot.drawing import new_figure

from odometry_sweep.results import METRICS, SHOWN

FILE = 'distributions.png'
BINS = 30
FULL = 0.85  # height of the highest bar; 1: the distance of two settings
WIDTH, ROW, FRAME = 3.2, 0.7, 1.4  # inches: of a diagram, of a setting, of titles and axes
HIGHEST = 60.0  # inches


def make_figure(tutorial, settings):
    """Return a figure with a diagram for each metric of the table, and a histogram per Setting."""
    metrics = SHOWN[tutorial]
    figure = new_figure(WIDTH * len(metrics), min(HIGHEST, FRAME + ROW * len(settings)))
    diagrams = figure.subplots(1, len(metrics), sharey=True)
    for metric, axes in zip(metrics, diagrams):
        _draw(axes, [setting.values(metric) for setting in settings])
        axes.set(title=metric, xlabel=METRICS[tutorial][metric])
        axes.grid(True, axis='x')
    diagrams[0].set_yticks(range(len(settings)), [setting.name for setting in settings])
    diagrams[0].invert_yaxis()
    figure.suptitle(f'{tutorial}, {sum(len(setting.rows) for setting in settings)} runs')
    return figure


def _draw(axes, rows):
    """Draw a histogram above the line of each row of values, and mark its median."""
    edges = numpy.histogram_bin_edges(numpy.concatenate(rows), BINS)
    for place, values in enumerate(rows):
        counts, _ = numpy.histogram(values, edges)
        axes.stairs(place - FULL * counts / counts.max(), edges, baseline=place, fill=True)
        axes.plot([numpy.median(values)] * 2, [place, place - FULL], color='black')
        axes.axhline(place, color='grey', linewidth=0.5)
    axes.ticklabel_format(axis='x', useOffset=False)
    axes.tick_params(axis='x', rotation=45)
