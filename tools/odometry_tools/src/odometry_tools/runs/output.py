"""Output of the demo, the check and the sweep: progress and complaints."""

import gc
import math
import os
import shutil
import signal
import sys
from pathlib import Path

REWRITE = '\r\033[K'  # moves to the start of a terminal's line and clears it
BAR_WIDTH = 30


class RunError(RuntimeError):
    """A run cannot continue; the message is one line for the user."""


class Line:
    """A status line: rewritten on a terminal, else printed every `period` from `first` on (s)."""

    def __init__(self, period, first=-math.inf):
        self._live = sys.stdout.isatty()
        self._period, self._next = period, first

    def show(self, text, now):
        """Show the text, at `now` seconds."""
        if self._live:
            # A text that wraps would leave a line behind at each update. Its end has the figures.
            fitting = text[1 - shutil.get_terminal_size().columns:]
            print(f'{REWRITE}{fitting}', end='', flush=True)
        elif now >= self._next:
            self._next = now + self._period
            print(text, flush=True)

    def finish(self, text):
        """Leave the text on the screen."""
        print(f'{REWRITE}{text}' if self._live else text, flush=True)


def bar(share):
    """Return a progress bar for a share from 0 to 1."""
    done = max(0, min(BAR_WIDTH, round(BAR_WIDTH * share)))
    return f'[{"=" * done:{BAR_WIDTH}}]'


def complain(text):
    """Print a line to stderr, after the program's name; it replaces the line of progress."""
    begin = f'{REWRITE if sys.stderr.isatty() else ""}{Path(sys.argv[0]).stem}'
    print(f'{begin}: {text}', file=sys.stderr, flush=True)


def run_command(run, mistakes):
    """Exit with the status of run(); with 2 for the user's mistakes, 1 for other known errors.

    :param mistakes: classes of errors, whose message is one line for the user
    """
    # ./ws ends its child by SIGTERM, whatever signal it receives.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        status = run()
        sys.stdout.flush()
    except BrokenPipeError:
        status = 128 + signal.SIGPIPE
    except KeyboardInterrupt:
        status = 128 + signal.SIGINT
    except (RunError, OSError, *mistakes) as error:
        complain(error)
        status = 2 if isinstance(error, mistakes) else 1
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a second one exits without a message
    forget_output()
    gc.freeze()  # or Python would look for cycles in all that it has imported, for 0.3 s
    sys.exit(status)


def forget_output():
    """Discard output that has no reader, or Python would fail to flush it at exit."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
