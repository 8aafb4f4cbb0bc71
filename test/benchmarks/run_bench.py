"""Measure speed, latency, start and end, each beside the limit of this machine.

Each figure is measured in turns with its limit. Compare ratios: the values
depend on the machine. The exit status is 1 if a target was missed.
"""

import argparse
import os
import platform
import sys
from statistics import median

import figures  # noqa: F401 - fills FIGURES
import rospy
from odometry_tests.processes import Master
from registry import FIGURES

WIDTHS = '{:<44} {:>10} {:<21} {:>10} {:>8}  {}'


def main():
    options = parse(sys.argv[1:])
    print(f'on {machine()}; medians of {options.runs} runs')
    print(WIDTHS.format('name', 'value', 'unit', 'limit', 'ratio', 'target'), flush=True)
    with Master(use_sim_time=True):
        # The clock of the simulators must not become the clock of what measures them.
        rospy.init_node('bench', disable_signals=True, disable_rostime=True)
        missed = [name for name in options.only or sorted(FIGURES) if not is_met(FIGURES[name], options)]
    print(f'targets missed: {", ".join(missed) or "none"}')
    sys.exit(1 if missed else 0)


def is_met(figure, options):
    """Measure and print a figure; return whether it meets its target."""
    pairs = figure.measure(options)
    value, limit, ratio = map(median, zip(*((value, limit, value / limit) for value, limit in pairs)))
    meets = ratio >= figure.bound if figure.relation == '>=' else ratio <= figure.bound
    target = f'{figure.relation} {figure.bound:g}{"" if meets else "  MISSED"}'
    print(WIDTHS.format(figure.title, f'{value:.4g}', figure.unit, f'{limit:.4g}', f'{ratio:.3f}', target),
          flush=True)
    return meets


def machine():
    with open('/proc/cpuinfo') as file:
        models = {line.partition(':')[2].strip() for line in file if line.startswith('model name')}
    return (f'{" and ".join(models) or platform.machine()}, {os.cpu_count()} processors, '
            f'Linux {platform.release()}, Python {platform.python_version()}')


def parse(arguments):
    parser = argparse.ArgumentParser(prog='./ws bench', description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('only', nargs='*', metavar='FIGURE', help=f'only these: {", ".join(sorted(FIGURES))}')
    parser.add_argument('--runs', type=int, default=3, metavar='N',
                        help='of which the median is shown (default: %(default)s)')
    parser.add_argument('--window', type=float, default=1.0, metavar='S',
                        help='wall time of one look at a speed (default: %(default)s)')
    options = parser.parse_args(arguments)
    unknown = {*options.only} - {*FIGURES}
    if unknown or options.runs < 1 or not options.window > 0:
        parser.error(f'no figure {", ".join(unknown)}' if unknown else '--runs and --window must be positive')
    return options


if __name__ == '__main__':
    main()
