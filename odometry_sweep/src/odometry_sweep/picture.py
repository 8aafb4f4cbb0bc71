"""A picture with the distributions of the metrics of a sweep."""

import numpy
from odometry_launch.figure import BLUE, DARK, new_figure, tidy

from odometry_sweep.results import METRICS, SHOWN

FILE = 'distributions.png'
DIGITS = 6  # of a value; those after them are noise of rounding
WIDTH, ROW, FRAME, MARGIN = 2.2, 0.4, 1.5, 1.5  # inches: a diagram, a combination, titles and axes, labels
MIN_SPANS = {'m': 0.01, 'degrees': 0.5, 's': 0.5}  # on a shorter axis noise looks large
MAX_HEIGHT = 60.0  # inches


def make_figure(kind, combinations):
    """Return a figure with a diagram for each metric, and in it a box plot of each Combination."""
    values = {metric: [combination.values(metric) for combination in combinations]
              for metric in SHOWN[kind]}
    # A diagram of a constant shows nothing.
    metrics = [metric for metric, rows in values.items()
               if numpy.ptp(numpy.concatenate(rows)).round(DIGITS)]
    metrics = metrics or SHOWN[kind][:1]
    figure = new_figure(MARGIN + WIDTH * len(metrics), min(MAX_HEIGHT, FRAME + ROW * len(combinations)),
                        layout='constrained')
    diagrams, = figure.subplots(1, len(metrics), sharey=True, squeeze=False)
    for metric, axes in zip(metrics, diagrams):
        unit = METRICS[kind][metric]
        axes.boxplot(values[metric], vert=False, whis=(5, 95), widths=0.6, patch_artist=True, manage_ticks=False,
                     boxprops={'facecolor': BLUE, 'linewidth': 0}, medianprops={'color': DARK, 'linewidth': 2},
                     flierprops={'marker': '.', 'markeredgewidth': 0, 'markerfacecolor': BLUE})
        low, high = axes.get_xlim()
        margin = max(0.0, MIN_SPANS[unit] - (high - low)) / 2
        axes.set_xlim(low - margin, high + margin)
        axes.ticklabel_format(axis='x', useOffset=False, style='plain')
        axes.locator_params(axis='x', nbins=3)
        axes.set_title(f'{metric.replace("_", " ")} ({unit})')
    tidy(*diagrams)
    diagrams[0].set_yticks(range(1, len(combinations) + 1), [combination.name for combination in combinations])
    diagrams[0].invert_yaxis()
    figure.suptitle(f'{kind}, {sum(len(combination.rows) for combination in combinations)} runs', color=DARK)
    figure.supxlabel('line: median; box: quartiles; whiskers: 5 and 95 %; dots: runs beyond', fontsize=9)
    return figure
