#!/usr/bin/env python3
"""Draw a run from a bag with odometry, of a simulated or a real robot, and print its figures."""

import argparse
import os
import sys
from pathlib import Path

from odometry_tools.runs.figure import make_figure
from odometry_tools.runs.folders import path_in_errors
from odometry_tools.runs.recorded_run import BagError, read_run

EXIT_BAD_BAG = 2


def make_parser():
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(prog='plot_run.py', description=__doc__, allow_abbrev=False)
    parser.add_argument('bag', metavar='BAG', help='the recording')
    parser.add_argument('-o', '--output', metavar='PNG',
                        help='the picture (default: beside the bag, with its name)')
    parser.add_argument('--topic',
                        help='the odometry (default: /odom, or the only odometry in the bag)')
    return parser


def main():
    """Read the bag, print, draw."""
    options = make_parser().parse_args()
    try:
        run = read_run(options.bag, options.topic)
        picture = Path(options.output or Path(options.bag).with_suffix('.png'))
        if os.path.realpath(picture) == os.path.realpath(options.bag):
            raise BagError(f'{picture} is the recording; the picture needs another name: -o PNG')
        with path_in_errors(picture):
            # Without a format, matplotlib would append one to the name.
            make_figure(run).savefig(picture, format='png')
    except (BagError, OSError, ValueError) as error:
        print(f'plot_run: {error}', file=sys.stderr)
        sys.exit(EXIT_BAD_BAG)
    print(f'{run.summary()}\npicture     {picture}')


if __name__ == '__main__':
    main()
