"""How far a robot has moved: the sum of the steps between its odometry's positions."""

import math
from collections import deque
from typing import NamedTuple

from odometry_common.parameters import Parameter, Parameters

MIN_DISTANCE = 1e-6  # m; a smaller total is reported as zero, as in the tutorial
MAX_STEP = 1e300  # m; longer steps could overflow the sum

PARAMETERS = Parameters(
    Parameter('~min_step', 0.0,
              'count the displacement from the last counted position once it reaches this',
              'm', 'from 0'),
    Parameter('~max_speed', 5.0,
              'warn of a faster step, a jump, and do not count it; 0 counts every step',
              'm/s', 'from 0'))


class Position(NamedTuple):
    """A position of the robot."""

    x: float  # m
    y: float  # m
    stamp: float  # s, when it was measured
    arrival: float  # s, when the message arrived


class DistanceCounter:
    """Adds the steps between consecutive positions in the plane, except jumps."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Count steps of at least `min_step` (m) and at most `max_speed` (m/s; 0: any)."""
        self._min_step = min_step
        self._max_speed = max_speed
        self._total = 0.0
        self._counted = None  # the Position where the last counted step ended
        self._last = None
        self._late = None
        self._period = UsualPeriod()

    @property
    def distance(self):
        """Metres counted so far; exactly 0.0 below a micrometre."""
        return self._total if self._total >= MIN_DISTANCE else 0.0

    def reset(self):
        """Start from zero at the last position."""
        self._total = 0.0
        self._counted = self._last

    def add(self, x, y, stamp, arrival):
        """Add the robot's next position.

        :param x, y: position (m)
        :param stamp, arrival: when it was measured and when it arrived (s)
        :return: None, or why this step is not counted as movement
        :raises ValueError: if x or y is not finite; nothing changes then
        """
        if not (math.isfinite(x) and math.isfinite(y)):
            raise ValueError(f'the position ({x}, {y}) is not finite')
        here = Position(x, y, stamp, arrival)
        if self._is_late(here):
            return f'the time stamp went back by {self._last.stamp - stamp:.3f} s'
        jump = self._jump(here) if self._last else None
        self._last = here
        if jump or self._counted is None:
            self._counted = here
            return jump
        step = math.hypot(x - self._counted.x, y - self._counted.y)
        if step >= self._min_step:
            self._total += step
            self._counted = here
        return None

    def _is_late(self, here):
        """Return whether to ignore this position because it is older than the last.

        Other messages have overtaken it, or it is a copy. But if the next one continues from it,
        time has restarted: a simulator was reset, a bag started again. Then only the step between
        these two counts.
        """
        late, self._late = self._late, None
        if self._last is None or here.stamp >= self._last.stamp:
            return False
        if late and here.stamp >= late.stamp and here[:3] != late[:3]:
            self._last = self._counted = late
            return False
        self._late = here
        return True

    def _jump(self, here):
        """Return why the step from the last position to this one is not movement, or None."""
        available = self._available_time(here)
        uncounted = math.hypot(here.x - self._counted.x, here.y - self._counted.y)
        if uncounted > MAX_STEP:
            return f'a step of {uncounted} m is no movement'
        step = math.hypot(here.x - self._last.x, here.y - self._last.y)
        if self._max_speed and step / self._max_speed > available:
            return f'a step of {step:.3f} m in {available:.3f} s is faster than ~max_speed'
        return None

    def _available_time(self, here):
        """Return how long (s) the robot may have moved since the last position."""
        interval = here.stamp - self._last.stamp
        if interval == 0:  # for example, the driver does not stamp its messages
            interval = max(0.0, here.arrival - self._last.arrival)
        usual = self._period.mean
        self._period.add(interval)
        # Messages that were delayed together have nearly the same stamp, but the robot has moved
        # for as long as between any others.
        return max(interval, usual)


class UsualPeriod:
    """The mean time between messages over the last second with messages.

    A mean, because a late message lengthens one interval and shortens the next. Over a time and not
    over a number of messages, so that a burst weighs no more than the pause before it, and a new
    rate soon prevails. A longer silence is left out.
    """

    WINDOW = 1.0  # s
    FIRST_GUESS = 0.05  # s, before the first interval; the tutorial's robot sends at 20 Hz
    MAX_COUNT = 1000  # messages in the window

    def __init__(self):
        # Times of the messages, by a clock that stops in each silence.
        self._times = deque([0.0], self.MAX_COUNT)

    @property
    def mean(self):
        """The mean (s)."""
        intervals = len(self._times) - 1
        return (self._times[-1] - self._times[0]) / intervals if intervals else self.FIRST_GUESS

    def add(self, interval):
        """Add the time from one message to the next (s)."""
        if interval >= self.WINDOW:
            return
        self._times.append(self._times[-1] + interval)
        while self._times[-1] - self._times[0] > self.WINDOW:
            self._times.popleft()
