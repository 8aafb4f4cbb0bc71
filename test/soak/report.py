"""What the soak prints."""

import sys
import time
from datetime import timedelta

SECONDS_PER_HOUR = 3600
TERMINAL_PERIOD = 1.0  # s of wall time between two updates of the line on a terminal


class Progress:
    """One line that changes on a terminal, else one line for each simulated hour."""

    def __init__(self):
        """Begin now."""
        self._start = time.monotonic()
        self._shown = 0

    def show(self, driver):
        """Print where the driver is if it is time to."""
        wall = time.monotonic() - self._start
        if sys.stdout.isatty():
            count = int(wall / TERMINAL_PERIOD)
        else:
            count = int(driver.seconds / SECONDS_PER_HOUR)
        if count == self._shown:
            return
        self._shown = count
        line = (f'{_clock(driver.seconds)} simulated, {driver.metres:.0f} m, '
                f'{driver.seconds / wall:.0f} x real time')
        print(f'\r\033[K{line}' if sys.stdout.isatty() else line,
              end='' if sys.stdout.isatty() else '\n', flush=True)

    @staticmethod
    def end():
        """Leave the line."""
        if sys.stdout.isatty():
            print()


def summary(driver, violation, wall):
    """Return the whole result; `violation`: None or the one that ended it, `wall`: seconds."""
    rows = [('simulated time', _clock(driver.seconds)), ('driven', f'{driver.metres:.1f} m'),
            ('steps checked', driver.steps), *driver.events.items(),
            *_memory_rows(driver.usage), ('wall time', _clock(wall)),
            ('violations', 0 if violation is None else 1)]
    lines = [f'{name + ":":28}{value}' for name, value in rows]
    if violation is not None:
        lines.append(f'violation at step {driver.steps + 1}: {violation}')
    return '\n'.join(lines)


def _memory_rows(usage):
    for name, first in usage.first.items():
        last = usage.last[name]
        change = ', '.join(f'{before:.4g} -> {now:.4g} {unit}' for before, now, unit
                           in zip(first, last, ('MB', 'threads', 'files')))
        yield f'memory of {name}', change


def _clock(seconds):
    return str(timedelta(seconds=round(seconds)))
