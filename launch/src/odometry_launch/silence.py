"""A robot that has fallen silent."""

import time

from odometry_launch.monitors import ODOMETRY_PERIOD
from odometry_launch.output import complain

PATIENCE = 10.0  # s of wall time
MESSAGES = 4  # that should have come, before silence is worth a word


class Silence:
    """Reports it once each time; only the user knows whether the robot is paused."""

    def __init__(self, real_time_factor):
        """Take the pace, simulated seconds per second; 0: any."""
        self._patience = PATIENCE
        if real_time_factor:
            self._patience = max(PATIENCE, MESSAGES * ODOMETRY_PERIOD / real_time_factor)
        self._now = self._since = None

    def look(self, now):
        """Take the robot's time."""
        if now != self._now:
            self._now, self._since = now, time.monotonic()
        elif self._since is not None and time.monotonic() - self._since > self._patience:
            self._since = None
            complain(f'nothing has come from the robot for {self._patience:g} s; is it paused? '
                     'Ctrl-C ends the demo')
