"""A picture with the distributions of the metrics of a sweep."""

import numpy

from odometry_tools.runs.figure import BLUE, DARK, ORANGE, PALE, new_figure, tidy
from odometry_tools.sweep.results import METRICS, SHOWN, statistics

FILE = 'distributions.png'
# inches: a diagram, a combination, titles and axes, labels
WIDTH, ROW, FRAME, MARGIN = 2.2, 0.4, 1.5, 1.5
MIN_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # on a shorter axis noise looks large
MAX_HEIGHT = 60.0  # inches
HISTOGRAM, BARS = 2.2, 12  # inches: the height of a histogram; its number of bars


def make_figure(subject, combinations):
    """Return a figure with a diagram for each metric.

    It has a line for each Combination; of one alone it is a histogram of its runs.
    """
    units = METRICS[subject.kind]
    values = {
        metric: [combination.values(metric) for combination in combinations]
        for metric in SHOWN[subject.kind]}
    # A diagram of a constant, or of rounding, shows nothing.
    metrics = [
        metric for metric, rows in values.items()
        if numpy.ptp(numpy.concatenate(rows)).round(6)]
    metrics = metrics or SHOWN[subject.kind][:1]
    is_alone = len(combinations) == 1
    height = HISTOGRAM if is_alone else ROW * len(combinations)
    size = MARGIN + WIDTH * len(metrics), min(MAX_HEIGHT, FRAME + height)
    figure = new_figure(*size, layout='constrained')
    diagrams, = figure.subplots(1, len(metrics), sharey=True, squeeze=False)
    for metric, axes in zip(metrics, diagrams):
        span = MIN_SPANS[units[metric]]
        if is_alone:
            handles = _draw_histogram(axes, *values[metric], span)
        else:
            handles = _draw(axes, values[metric])
        _show_at_least(span, axes)
        axes.ticklabel_format(axis='x', useOffset=False, style='plain')
        axes.locator_params(axis='x', nbins=3)
        axes.set_title(f'{metric.replace("_", " ")} ({units[metric]})')
    tidy(*diagrams)
    if is_alone:
        _count_runs_on(diagrams[0])
    else:
        _name_lines_of(diagrams[0], combinations)
    figure.legend(handles=handles, loc='outside lower center', ncols=len(handles), frameon=False)
    runs = sum(len(combination.rows) for combination in combinations)
    figure.suptitle(f'{subject.name}, {runs} runs', color=DARK)
    return figure


def _count_runs_on(axes):
    """Label the vertical axis of a histogram."""
    axes.set_ylabel('runs')
    axes.yaxis.get_major_locator().set_params(integer=True)


def _name_lines_of(axes, combinations):
    """Write the name of each Combination beside its line; the first is at the top."""
    names = [combination.name for combination in combinations]
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.5, -0.5)


def _show_at_least(span, axes):
    """Widen the horizontal axis to a span of values."""
    low, high = axes.get_xlim()
    margin = max(0.0, span - (high - low)) / 2
    axes.set_xlim(low - margin, high + margin)


def _draw_histogram(axes, values, span):
    """Draw how many runs have which value, over at least this span, and the table's statistics."""
    margin = max(0.0, span - numpy.ptp(values)) / 2
    shown = values.min() - margin, values.max() + margin
    *_, bars = axes.hist(values, BARS, range=shown, color=BLUE, label='runs')
    median, low, high, _ = statistics(values).values()
    most = axes.axvspan(low, high, color=PALE, alpha=0.4, zorder=0, label='5 to 95 %')
    middle = axes.axvline(median, color=ORANGE, linewidth=2, label='median')
    return bars[0], most, middle


def _draw(axes, rows):
    """Draw each row of values, and what the table says of it."""
    places = range(len(rows))
    heights = numpy.repeat(places, [len(row) for row in rows])
    runs, = axes.plot(numpy.concatenate(rows), heights, '|', color=BLUE, markersize=12,
                      markeredgewidth=0.5, label='each run')
    medians, lows, highs, _ = zip(*(statistics(row).values() for row in rows))
    most = axes.hlines(places, lows, highs, color=BLUE, linewidth=3, label='5 to 95 %')
    median, = axes.plot(medians, places, 'o', color=ORANGE, label='median')
    return runs, most, median
