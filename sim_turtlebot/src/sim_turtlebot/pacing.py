"""Pace simulated time by the wall clock."""

import time

MAX_LAG = 0.25  # s; a simulation that is further behind does not catch up
MAX_SLIPS = 10  # in a row; fewer are a hiccup
MAX_SLIP_GAP = 3.0  # s between two slips in a row: a machine that reaches less than nine tenths
RECOVERY_TIME = 30.0  # s without a slip


class Pacer:
    """Keeps simulated time from running ahead of the wall clock."""

    def __init__(self, real_time_factor, on_pace=lambda reached: None):
        """Run at `real_time_factor` simulated seconds per second; 0: as fast as possible.

        :param on_pace: called with the factor that the machine reaches once it is too slow; with
            None once it has caught up
        """
        self._factor = real_time_factor
        self._on_pace = on_pace
        self._is_slow = False
        self.restart(0)

    def restart(self, now):
        """Measure from here on; `now` is simulated time (ns)."""
        self._start, self._wall_start = now, time.monotonic()
        self._slips, self._last_slip = 0, self._wall_start

    def lead(self, now):
        """Return how far (s of wall time) the simulation is ahead; 0 or less: advance."""
        if self._factor == 0:
            return 0.0
        due = (now - self._start) / 1e9 / self._factor
        wall = time.monotonic()
        lead = due - (wall - self._wall_start)
        if lead < -MAX_LAG:
            self._slip(now, wall)
            self._start, self._wall_start = now, wall
        elif self._is_slow and wall - self._last_slip > RECOVERY_TIME:
            self._is_slow = False
            self._on_pace(None)
        return lead

    def _slip(self, now, wall):
        """Report a machine that falls behind MAX_SLIPS times in a row."""
        if wall - self._last_slip > MAX_SLIP_GAP:
            self._slips = 0
        if self._slips == 0:
            self._first_slip = now, wall
        self._slips += 1
        self._last_slip = wall
        if self._slips >= MAX_SLIPS and not self._is_slow:
            self._is_slow = True
            then, wall_then = self._first_slip
            self._on_pace((now - then) / 1e9 / (wall - wall_then))
