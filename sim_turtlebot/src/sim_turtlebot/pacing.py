"""Keeping simulated time to its share of the wall clock."""

import time

LARGEST_LAG = 0.25  # s; a simulation further behind than this does not rush to catch up
SLIPS = 10  # in a row are more than a hiccup
LONGEST_GAP = 3.0  # s between them: a machine that is slower than nine tenths
RECOVERY = 30.0  # s without one
BUSY_SHARE = 0.8  # of a processor; a simulation that gets less waits for others


class Pacer:
    """Keeps simulated time from running ahead of the wall clock."""

    def __init__(self, real_time_factor, on_pace=lambda reached, share: None):
        """Allow `real_time_factor` simulated seconds per second; 0: any number.

        :param on_pace: called with the factor that the machine reaches once it proves too slow, and
            the share of one processor that this process uses; with None and 0 once it has caught up
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
        if lead < -LARGEST_LAG:
            self._slip(now, wall)
            self._start, self._wall_start = now, wall
        elif self._is_slow and wall - self._last_slip > RECOVERY:
            self._is_slow = False
            self._on_pace(None, 0.0)
        return lead

    def _slip(self, now, wall):
        """Report a machine that falls behind again and again; once is only a hiccup."""
        if wall - self._last_slip > LONGEST_GAP:
            self._slips = 0
        if self._slips == 0:
            self._first_slip = now, wall, time.process_time()
        self._slips += 1
        self._last_slip = wall
        if self._slips >= SLIPS and not self._is_slow:
            self._is_slow = True
            then, wall_then, cpu_then = self._first_slip
            self._on_pace((now - then) / 1e9 / (wall - wall_then),
                          (time.process_time() - cpu_then) / (wall - wall_then))


def describe_pace(reached, wanted, share):
    """Return what to say of a pace, and what helps; '' if the simulation has caught up.

    :param reached, share: as a Pacer reports them
    :param wanted: real-time factor
    """
    if reached is None:
        return f'the simulation keeps pace again: real-time factor {wanted:g}', ''
    text = f'the simulation is too slow: it reaches a real-time factor of {reached:.2g} instead of {wanted:g}'
    help_text = ('fewer robots, no ~gui, a lower ~odom_rate or ~real_time_factor help' if share > BUSY_SHARE
                 else 'perhaps other programs need the processors, such as windows that render without a '
                 'graphics card')
    return text, f'with {share:.0%} of a processor; {help_text}'
