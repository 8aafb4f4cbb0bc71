"""What holds the simulation back: the wall clock, and controllers that have not answered."""

import time

LARGEST_LAG = 0.25  # s; who is further behind than this does not rush to catch up


class Pacer:
    """Keeps simulated time from running ahead of the wall clock."""

    def __init__(self, real_time_factor):
        """Allow `real_time_factor` simulated seconds per second; 0: any number."""
        self._factor = real_time_factor
        self.restart(0)

    def restart(self, now):
        """Measure from here on; `now` is simulated time (ns)."""
        self._wall_start = time.monotonic()
        self._start = now

    def lead(self, now):
        """Return how far (s of wall time) the simulation is ahead; 0 or less: go on."""
        if self._factor == 0:
            return 0.0
        due = (now - self._start) / 1e9 / self._factor
        lead = due - (time.monotonic() - self._wall_start)
        if lead < -LARGEST_LAG:
            self.restart(now)
        return lead


class Lockstep:
    """Keeps the simulation from passing a multiple of 1/rate before each controller has spoken.

    A controller that has never spoken, or no longer does, is not waited for; one that speaks
    (again) is in step from the next multiple on.
    """

    def __init__(self, rate, step_rate, controllers):
        """Wait at `rate` (Hz) in steps of 1/step_rate for this many controllers."""
        self._steps_between = step_rate / rate
        self._controllers = range(controllers)
        self._in_step = set()
        self.restart()

    def restart(self):
        """Begin again at time zero."""
        self._wait_at(0)
        self._awaited = set(self._controllers)

    @property
    def started(self):
        """Whether any controller has ever spoken."""
        return bool(self._in_step)

    @property
    def last_step(self):
        """The step that is the last one that may be taken without asking must_wait() again."""
        return self._last_step

    def heard(self, controller):
        """Take note of a command from a controller (an index)."""
        self._in_step.add(controller)
        self._awaited.discard(controller)

    def must_wait(self, steps):
        """Tell whether the step after so many has to wait for a command."""
        if steps < self._last_step:
            return False
        if self._awaited:
            return True
        self._wait_at(self._multiple + 1)
        self._awaited = set(self._in_step)
        return False

    def give_up(self):
        """Go on without those who are awaited; tell whether one of them used to be in step."""
        lost = bool(self._awaited & self._in_step)
        self._in_step -= self._awaited
        self._awaited.clear()
        return lost

    def _wait_at(self, multiple):
        self._multiple = multiple
        # The small term keeps a multiple that falls on a step from being rounded off it.
        self._last_step = int(multiple * self._steps_between + 1e-6)
