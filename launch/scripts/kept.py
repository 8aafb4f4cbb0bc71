#!/usr/bin/env python3
"""Run a program, and end it with all that it has started, however this process ends.

usage: kept.py PROGRAM [ARGUMENT...]
"""

import sys

# Until there is something to end, Ctrl-C has nothing to say; in the import of `signal`, which
# takes some milliseconds, it would show a traceback. This is what it is made of.
from _signal import SIG_DFL, SIGINT, signal

signal(SIGINT, SIG_DFL)


def main():
    """Stand in for the program."""
    from odometry_launch.keeping import stand_in
    return stand_in(sys.executable, *sys.argv[1:])


if __name__ == '__main__':
    sys.exit(main())
