"""What the demo prints beside the robot's progress."""

import os
import sys

REWRITE = '\r\033[K'  # goes back to the beginning of a terminal's line, and empties it


def complain(text):
    """Print a line to stderr, in place of a line of progress that may be there."""
    print(f'{REWRITE if sys.stderr.isatty() else ""}demo: {text}', file=sys.stderr, flush=True)


def forget_output():
    """Keep Python from flushing at exit what nobody reads."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
