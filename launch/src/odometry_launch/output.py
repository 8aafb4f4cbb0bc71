"""What the demo and the sweep print to show that they go on, and in place of that."""

import os
import sys

REWRITE = '\r\033[K'  # goes back to the beginning of a terminal's line, and empties it
BAR_WIDTH = 30


def bar(share):
    """Return a bar that shows how much is done, from 0 to 1."""
    done = max(0, min(BAR_WIDTH, round(BAR_WIDTH * share)))
    return f'[{"=" * done:{BAR_WIDTH}}]'


def complain(text, program='demo'):
    """Print a line to stderr, in place of a line of progress that may be there."""
    print(f'{REWRITE if sys.stderr.isatty() else ""}{program}: {text}', file=sys.stderr, flush=True)


def forget_output():
    """Keep Python from flushing at exit what nobody reads."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
