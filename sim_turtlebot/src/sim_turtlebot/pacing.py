"""What holds the simulation back: the wall clock, and controllers that have not answered."""

import time

LARGEST_LAG = 0.25  # s; who is further behind than this does not rush to catch up
SLIPS = 10  # so many in a row are no hiccup
LONGEST_GAP = 3.0  # s between them: a machine that is slower than nine tenths
RECOVERY = 30.0  # s without one


class Pacer:
    """Keeps simulated time from running ahead of the wall clock."""

    def __init__(self, real_time_factor, on_pace=lambda reached: None):
        """Allow `real_time_factor` simulated seconds per second; 0: any number.

        :param on_pace: is told what factor the machine reaches once it proves too slow, and None
            once it has caught up
        """
        self._factor = real_time_factor
        self._slowness = Slowness()
        self._on_pace = on_pace
        self.restart(0)

    def restart(self, now):
        """Measure from here on; `now` is simulated time (ns)."""
        wall = time.monotonic()
        self._slowness.interrupt(wall)
        self._begin(now, wall)

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
            self._begin(now, wall)
        elif self._slowness.is_over(wall):
            self._on_pace(None)
        return lead

    def _begin(self, now, wall):
        self._wall_start = wall
        self._start = now


class Slowness:
    """Notices that a machine falls behind again and again; once is no more than a hiccup.

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
        """Take note that the pace is given up; return, but once, the pace of a slow machine."""
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
        """Return, but once, whether a slow machine has kept pace for a while."""
        over = self._known and wall - self._last > RECOVERY
        if over:
            self._known = False
        return over


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
