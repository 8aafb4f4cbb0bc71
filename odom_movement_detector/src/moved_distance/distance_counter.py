"""How far a robot has moved, added up from where its odometry has it."""

import math
from collections import deque
from typing import NamedTuple

SMALLEST_DISTANCE = 1e-6  # m; a smaller total is given as zero, as in the tutorial


class DistanceCounter:
    """The sum of the steps between consecutive positions in the plane."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Take the smallest step counted (m) and the speed (m/s, 0: any) of a jump."""
        self._min_step = min_step
        self._max_speed = max_speed
        self._total = 0.0
        self._counted = None
        self._last = None
        self._late = None
        self._period = UsualPeriod()

    @property
    def distance(self):
        """Metres counted so far; exactly 0.0 while under a micrometre."""
        return self._total if self._total >= SMALLEST_DISTANCE else 0.0

    def reset(self):
        """Start from zero at the last position."""
        self._total = 0.0
        self._counted = self._last

    def add(self, x, y, stamp, arrival):
        """Take the robot's next position.

        :param x, y: position (m)
        :param stamp, arrival: when it was measured and when it arrived (s)
        :return: None, or why this step was not counted
        :raises ValueError: if x or y is not finite; nothing has changed then
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
        step = _distance(here, self._counted)
        if step >= self._min_step:
            self._total += step
            self._counted = here
        return None

    def _is_late(self, here):
        """Return whether this position is older than the last, and so is to be ignored.

        One such message was overtaken by others or is a copy. But when the next one goes on from
        it, time has restarted: a simulator was reset, a bag began again. Then all that counts is
        the step between these two.
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
        """Return why the way from the last position to this one is no movement, or None."""
        available = self._available_time(here)
        if not math.isfinite(self._total + _distance(here, self._counted)):
            return f'a step of {_distance(here, self._counted)} m is no movement'
        step = _distance(here, self._last)
        if self._max_speed and step / self._max_speed > available:
            return f'a step of {step:.3f} m in {available:.3f} s is faster than ~max_speed'
        return None

    def _available_time(self, here):
        """Return how long (s) the robot may have been on its way from the last position."""
        interval = here.stamp - self._last.stamp
        if interval == 0:  # from a driver that does not stamp its messages, for example
            interval = max(0.0, here.arrival - self._last.arrival)
        usual = self._period.mean
        self._period.add(interval)
        # Messages that were delayed together have nearly the same stamp, but the robot has moved
        # between them for as long as between any others.
        return max(interval, usual)


class UsualPeriod:
    """The mean time between messages, over the last second in which there were any.

    A mean, because messages that come late leave it as it is: what one interval lacks, another
    has too much. Over a time and not a number of messages, because a hundred of them in one burst
    then weigh no more than the pause before, and a new rate soon prevails. A longer silence
    is not how messages usually follow each other, and is left out.
    """

    WINDOW = 1.0  # s
    FIRST_GUESS = 0.05  # s, until there was an interval; the tutorial's robot sends at 20 Hz
    LARGEST_COUNT = 1000  # messages in the window

    def __init__(self):
        """Begin with the first message."""
        # When the messages were, by a clock that stands still in each silence.
        self._times = deque([0.0], self.LARGEST_COUNT)

    @property
    def mean(self):
        """Seconds."""
        intervals = len(self._times) - 1
        return (self._times[-1] - self._times[0]) / intervals if intervals else self.FIRST_GUESS

    def add(self, interval):
        """Take the time from one message to the next (s)."""
        if interval >= self.WINDOW:
            return
        self._times.append(self._times[-1] + interval)
        while self._times[-1] - self._times[0] > self.WINDOW:
            self._times.popleft()


class Position(NamedTuple):
    """Where the robot was."""

    x: float  # m
    y: float  # m
    stamp: float  # s, when it was there
    arrival: float  # s, when the message arrived


def _distance(a, b):
    return math.hypot(a.x - b.x, a.y - b.y)
