"""Measure speed, latency, start and end, each beside the limit of this machine.

Each figure is a file in the folder test/benchmarks/figures. Its limit is measured in turns with it;
their ratio is what tells, since absolute values belong to the machine. The exit status is 1 if a
target was missed.
"""

import argparse
import csv
import math
import os
import platform
import sys
from importlib import import_module
from pathlib import Path

import rospy
from measuring import Figure, Options
from odometry_launch.folders import RUNS, new_folder
from odometry_tests.processes import Master

NAMES = sorted(file.stem for file in Path(__file__).parent.glob('figures/*.py'))
WIDTHS = '{:<44} {:>10} {:<21} {:>10} {:>8}  {}'


def main():
    options = parse(sys.argv[1:])
    print(f'on {machine()}; medians of {options.runs} runs')
    print(WIDTHS.format('name', 'value', 'unit', 'limit', 'ratio', 'target'), flush=True)
    with Master(use_sim_time=True):
        # The clock of the simulators must not become the clock of what measures them.
        rospy.init_node('bench', disable_signals=True, disable_rostime=True)
        figures = [measure(name, Options(options.runs, options.window)) for name in options.only]
    path = options.csv or new_folder(RUNS, 'bench-') / 'figures.csv'
    write_csv(figures, path)
    missed = [figure.name for figure in figures if figure.is_missed]
    print(f'figures  {path}\ntargets missed: {", ".join(missed) or "none"}')
    sys.exit(1 if missed else 0)


def measure(name, options):
    """Measure a figure, print its row, and return it."""
    figure = Figure.of(import_module(f'figures.{name}'), options)
    print(WIDTHS.format(
        figure.name, f'{figure.value:.4g}', figure.unit, f'{figure.limit:.4g}', f'{figure.ratio:.3f}',
        f'{figure.target}{"  MISSED" if figure.is_missed else ""}'), flush=True)
    return figure


def machine():
    with open('/proc/cpuinfo') as file:
        models = {line.partition(':')[2].strip() for line in file if line.startswith('model name')}
    return (f'{" and ".join(models) or platform.machine()}, {os.cpu_count()} processors, '
            f'Linux {platform.release()}, Python {platform.python_version()}')


def write_csv(figures, path):
    """Write the figures with all their digits."""
    with open(path, 'w', newline='') as file:
        writer = csv.writer(file)
        writer.writerow(Figure._fields)
        writer.writerows(figures)


def parse(arguments):
    """Return the options; without the name of a figure all are measured."""
    parser = argparse.ArgumentParser(prog='./ws bench', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('only', nargs='*', metavar='FIGURE', type=_name,
                        help=f'measure only these: {", ".join(NAMES)}')
    parser.add_argument('--runs', type=_positive(int), default=3, metavar='N',
                        help='of which the median is shown (default: %(default)s)')
    parser.add_argument('--window', type=_positive(float), default=1.0, metavar='S',
                        help='wall time of one look at a speed (default: %(default)s)')
    parser.add_argument('--csv', type=Path, metavar='FILE',
                        help='write the figures there instead of into the folder runs')
    options = parser.parse_args(arguments)
    options.only = options.only or NAMES
    return options


def _name(text):
    if text not in NAMES:
        raise argparse.ArgumentTypeError(f'{text!r} is not one of {", ".join(NAMES)}')
    return text


def _positive(kind):
    def parse_number(text):
        try:
            value = kind(text)
        except ValueError:
            value = 0
        if not 0 < value < math.inf:
            raise argparse.ArgumentTypeError(f'{text!r} is not a positive number')
        return value
    return parse_number


if __name__ == '__main__':
    main()
