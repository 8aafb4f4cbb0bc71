"""Figures as a table, as a CSV file and as a chart."""

import csv
import math
import os
import platform

from robots import COUNTS, robots
from run_plot.drawing import new_figure

WIDTHS = '{:<44} {:>10} {:<21} {:>10} {:>8}  {}'


def machine():
    """Return what this run was measured on, in a line."""
    with open('/proc/cpuinfo') as file:
        models = {line.partition(':')[2].strip() for line in file if line.startswith('model name')}
    return (f'{" and ".join(models) or platform.machine()}, {os.cpu_count()} processors, '
            f'Linux {platform.release()}, Python {platform.python_version()}')


def print_heading():
    """Print the names of the columns."""
    print(WIDTHS.format('name', 'value', 'unit', 'limit', 'ratio', 'target'), flush=True)


def print_figure(figure):
    """Print a row of the table."""
    target = f'{figure.target or ""}{"  MISSED" if figure.misses else ""}'
    print(WIDTHS.format(figure.name, _short(figure.value), figure.unit, _short(figure.limit),
                        '' if math.isnan(figure.ratio) else f'{figure.ratio:.3f}',
                        target).rstrip(), flush=True)


def write_csv(figures, path):
    """Write the figures with all their digits."""
    with open(path, 'w', newline='') as file:
        writer = csv.writer(file)
        writer.writerow(['name', 'value', 'unit', 'limit', 'ratio'])
        writer.writerows(figure[:5] for figure in figures)


def write_chart(figures, path):
    """Draw what a robot costs in small and in large crowds."""
    speeds = {figure.name: figure.value for figure in figures}
    cost = [1e3 / speeds[f'simulator, {robots(count)}'] / count for count in COUNTS]
    figure = new_figure(6, 4)
    axes = figure.subplots()
    axes.plot(COUNTS, cost, 'o-')
    axes.set(xscale='log', xticks=COUNTS, xticklabels=COUNTS, xlabel='robots in the simulator',
             ylabel='cost of a robot (ms per simulated s)', ylim=(0, 1.1 * max(cost)),
             title='sim_turtlebot, unpaced, all robots driving')
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    figure.savefig(path)


def _short(value):
    return f'{value:.4g}'
