#!/usr/bin/env python3
"""Draw a run from a bag with odometry in it, a real robot's too, and print its figures."""

import signal

# While the imports below run, Ctrl-C ends Python without a traceback.
signal.signal(signal.SIGINT, signal.SIG_DFL)

import argparse
import sys

from odometry_launch.figure import make_figure
from odometry_launch.recorded_run import BagError, read_run

EXIT_BAD_BAG = 2


def main():
    """Read the bag, print, draw."""
    parser = argparse.ArgumentParser(prog='plot_run.py', description=__doc__)
    parser.add_argument('bag', metavar='BAG')
    parser.add_argument('-o', '--output', metavar='PNG', default='run.png',
                        help='where to draw (default: %(default)s)')
    parser.add_argument('--topic', help='the odometry (default: /odom, or the only odometry in the bag)')
    options = parser.parse_args()
    try:
        run = read_run(options.bag, options.topic)
        make_figure(run).savefig(options.output)
    except (BagError, OSError, ValueError) as error:
        print(f'plot_run: {error}', file=sys.stderr)
        sys.exit(EXIT_BAD_BAG)
    print(f'{run.summary()}\npicture     {options.output}')


if __name__ == '__main__':
    main()
