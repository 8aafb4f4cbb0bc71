"""A robot that has stopped sending."""

import time

from odometry_launch.output import complain

PATIENCE = 10.0  # s of wall time
SIMULATED_PATIENCE = 0.2  # s; four odometries


class Silence:
    """Reports it, once each time; only the user knows whether the robot is paused."""

    def __init__(self, real_time_factor):
        """Take the simulated seconds per second; 0: any."""
        self._patience = PATIENCE
        if real_time_factor:
            self._patience = max(PATIENCE, SIMULATED_PATIENCE / real_time_factor)
        self._now = self._since = None

    def look(self, now):
        """Take the robot's time (s)."""
        if now != self._now:
            self._now, self._since = now, time.monotonic()
        elif self._since is not None and time.monotonic() - self._since > self._patience:
            self._since = None
            complain(f'nothing has come from the robot for {self._patience:g} s; is it paused? '
                     'Ctrl-C ends the demo')
