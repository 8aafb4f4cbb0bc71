"""How far the sweep is, and when it will be done."""

import sys
import time
from datetime import timedelta

from odometry_launch.output import REWRITE, bar


class Progress:
    """One line that is rewritten on a terminal; elsewhere a line every few seconds."""

    LIVE_PERIOD = 0.1  # s
    PERIOD = 5.0  # s

    def __init__(self, total):
        """Begin a sweep of so many runs."""
        self._total = total
        self._live = sys.stdout.isatty()
        self._done = 0
        self._first = None

    def step(self):
        """Note that one more run is done."""
        now = time.monotonic()
        if self._first is None:
            # Processes have to start before the first one, which says nothing about the others.
            self._first = now
            self._next = now + (0.0 if self._live else self.PERIOD)
        self._done += 1
        if now >= self._next:
            self._next = now + (self.LIVE_PERIOD if self._live else self.PERIOD)
            self._show(now, '')

    def finish(self):
        """Leave the line on the screen."""
        self._show(time.monotonic(), '\n')

    def _show(self, now, end):
        line = f'{bar(self._done / self._total)} {self._done} of {self._total} runs'
        if now > self._first and self._done > 1:
            speed = (self._done - 1) / (now - self._first)
            left = timedelta(seconds=round((self._total - self._done) / speed))
            line += f', {speed:.1f} a second, {left} left'
        if self._live:
            print(f'{REWRITE}{line}', end=end, flush=True)
        else:
            print(line, flush=True)
