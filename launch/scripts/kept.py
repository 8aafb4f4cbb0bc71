#!/usr/bin/env python3
"""Run a program, and end it with all that it has started, however this process ends.

usage: kept.py PROGRAM [ARGUMENT...]
"""

import signal
import sys

# Until there is something to end, Ctrl-C has nothing to say.
signal.signal(signal.SIGINT, signal.SIG_DFL)


def main():
    """Stand in for the program."""
    from odometry_launch.keeping import stand_in
    return stand_in(sys.executable, *sys.argv[1:])


if __name__ == '__main__':
    sys.exit(main())
