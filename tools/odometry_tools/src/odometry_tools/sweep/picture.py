"""A picture with the distributions of the metrics of a sweep."""

import numpy

from odometry_tools.runs.figure import BLUE, DARK, ORANGE, new_figure
from odometry_tools.sweep.results import METRICS, SHOWN, statistics

FILE = 'distributions.png'
# inches: a diagram, a combination, titles and axes, labels
WIDTH, ROW, FRAME, MARGIN = 2.2, 0.4, 1.5, 1.5
MIN_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # on a shorter axis noise looks large
MAX_HEIGHT = 60.0  # inches


def make_figure(subject, combinations):
    """Return a figure with a diagram for each metric, and in it a line for each Combination."""
    units = METRICS[subject.kind]
    values = {
        metric: [combination.values(metric) for combination in combinations]
        for metric in SHOWN[subject.kind]}
    # A diagram of a constant, or of rounding, shows nothing.
    metrics = [
        metric for metric, rows in values.items()
        if numpy.ptp(numpy.concatenate(rows)).round(6)]
    metrics = metrics or SHOWN[subject.kind][:1]
    size = MARGIN + WIDTH * len(metrics), min(MAX_HEIGHT, FRAME + ROW * len(combinations))
    figure = new_figure(*size, layout='constrained')
    diagrams, = figure.subplots(1, len(metrics), sharey=True, squeeze=False)
    for metric, axes in zip(metrics, diagrams):
        handles = _draw(axes, values[metric])
        _show_at_least(MIN_SPANS[units[metric]], axes)
        axes.ticklabel_format(axis='x', useOffset=False, style='plain')
        axes.locator_params(axis='x', nbins=3)
        axes.set_title(f'{metric.replace("_", " ")} ({units[metric]})')
    names = [combination.name for combination in combinations]
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)  # the first is at the top
    figure.legend(handles=handles, loc='outside lower center', ncols=len(handles), frameon=False)
    runs = sum(len(combination.rows) for combination in combinations)
    figure.suptitle(f'{subject.name}, {runs} runs', color=DARK)
    return figure


def _show_at_least(span, axes):
    """Widen the horizontal axis to a span of values."""
    low, high = axes.get_xlim()
    margin = max(0.0, span - (high - low)) / 2
    axes.set_xlim(low - margin, high + margin)


def _draw(axes, rows):
    """Draw each row of values, and the statistics in the table; return what the legend names."""
    places = range(len(rows))
    heights = numpy.repeat(places, [len(row) for row in rows])
    runs, = axes.plot(numpy.concatenate(rows), heights, '|', color=BLUE, markersize=12,
                      markeredgewidth=0.5, label='each run')
    medians, lows, highs, _ = zip(*(statistics(row).values() for row in rows))
    most = axes.hlines(places, lows, highs, color=BLUE, linewidth=3, label='5 to 95 %')
    median, = axes.plot(medians, places, 'o', color=ORANGE, label='median')
    return runs, most, median
