#!/usr/bin/env python3
"""Run a program, and end it with all that it has started, however this process ends.

usage: kept.py PROGRAM [ARGUMENT...]
"""

import sys

from odometry_launch.keeping import stand_in


def main():
    """Stand in for the program."""
    return stand_in(sys.executable, *sys.argv[1:])


if __name__ == '__main__':
    sys.exit(main())
