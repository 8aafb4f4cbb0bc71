"""Keeping simulated time to its share of the wall clock."""

import time

LARGEST_LAG = 0.25  # s; a simulation further behind than this does not rush to catch up
SLIPS = 10  # in a row are more than a hiccup
LONGEST_GAP = 3.0  # s between them: a machine that is slower than nine tenths
RECOVERY = 30.0  # s without one


class Pacer:
    """Keeps simulated time from running ahead of the wall clock."""

    def __init__(self, real_time_factor, on_pace=lambda reached: None):
        """Allow `real_time_factor` simulated seconds per second; 0: any number.

        :param on_pace: called with the factor that the machine reaches once it proves too slow, and
            with None once it has caught up
        """
        self._factor = real_time_factor
        self._slowness = Slowness()
        self._on_pace = on_pace
        self.restart(0)

    def restart(self, now):
        """Measure from here on; `now` is simulated time (ns)."""
        wall = time.monotonic()
        self._slowness.interrupt(wall)
        self._start, self._wall_start = now, wall

    def lead(self, now):
        """Return how far (s of wall time) the simulation is ahead; 0 or less: go on."""
        if self._factor == 0:
            return 0.0
        due = (now - self._start) / 1e9 / self._factor
        wall = time.monotonic()
        lead = due - (wall - self._wall_start)
        if lead < -LARGEST_LAG:
            reached = self._slowness.slip(now, wall)
            if reached is not None:
                self._on_pace(reached)
            self._start, self._wall_start = now, wall
        elif self._slowness.is_over(wall):
            self._on_pace(None)
        return lead


class Slowness:
    """Notices that a machine falls behind again and again; once is only a hiccup.

    Simulated times are in ns, those of the wall clock in s.
    """

    def __init__(self):
        """Begin with a machine that keeps pace."""
        self._known = False

    def interrupt(self, wall):
        """Forget how time went so far, as after a pause."""
        self._slips = 0
        self._last = wall

    def slip(self, now, wall):
        """Note that the pace was not kept; return the pace of a machine found to be slow, once."""
        if wall - self._last > LONGEST_GAP:
            self._slips = 0
        if self._slips == 0:
            self._first = now, wall
        self._slips += 1
        self._last = wall
        if self._known or self._slips < SLIPS:
            return None
        self._known = True
        return (now - self._first[0]) / 1e9 / (wall - self._first[1])

    def is_over(self, wall):
        """Return whether a slow machine has kept pace for a while; True only once."""
        over = self._known and wall - self._last > RECOVERY
        if over:
            self._known = False
        return over
