"""The steps between the positions of an odometry, as far as they are movement."""

import math
from typing import NamedTuple

from moved_distance.usual_period import UsualPeriod

LONGEST_STEP = 1e300  # m; so that no sum of steps is more than a float holds


class Position(NamedTuple):
    """Where the robot was."""

    x: float  # m
    y: float  # m
    stamp: float  # s, when it was there
    arrival: float  # s, when the message arrived


class Step(NamedTuple):
    """What one message adds to the path."""

    dx: float = 0.0  # m
    dy: float = 0.0  # m
    jump: str = None  # why the step is not counted as movement


class Steps:
    """The steps between consecutive positions in the plane; none where they are not movement."""

    def __init__(self, min_step=0.0, max_speed=5.0):
        """Take the smallest step counted (m) and the speed (m/s, 0: any) of a jump."""
        self._min_step = min_step
        self._max_speed = max_speed
        self._counted = None
        self._last = None
        self._late = None
        self._period = UsualPeriod()

    def restart(self):
        """Begin the next step at the last position."""
        self._counted = self._last

    def to(self, x, y, stamp, arrival):
        """Return the Step to the robot's next position.

        :param x, y: position (m)
        :param stamp, arrival: when it was measured and when it arrived (s)
        :raises ValueError: if x or y is not finite; nothing has changed then
        """
        if not (math.isfinite(x) and math.isfinite(y)):
            raise ValueError(f'the position ({x}, {y}) is not finite')
        here = Position(x, y, stamp, arrival)
        if self._is_late(here):
            return Step(jump=f'the time stamp went back by {self._last.stamp - stamp:.3f} s')
        jump = self._jump(here) if self._last else None
        self._last = here
        if jump or self._counted is None:
            self._counted = here
            return Step(jump=jump)
        step = Step(x - self._counted.x, y - self._counted.y)
        if math.hypot(step.dx, step.dy) < self._min_step:
            return Step()
        self._counted = here
        return step

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
        """Return why the step from the last position to this one is not movement, or None."""
        available = self._available_time(here)
        uncounted = math.hypot(here.x - self._counted.x, here.y - self._counted.y)
        if uncounted > LONGEST_STEP:
            return f'a step of {uncounted} m is no movement'
        step = math.hypot(here.x - self._last.x, here.y - self._last.y)
        if self._max_speed and step / self._max_speed > available:
            return f'a step of {step:.3f} m in {available:.3f} s is faster than ~max_speed'
        return None

    def _available_time(self, here):
        """Return how long (s) the robot may have moved since the last position."""
        interval = here.stamp - self._last.stamp
        if interval == 0:  # from a driver that does not stamp its messages, for example
            interval = max(0.0, here.arrival - self._last.arrival)
        usual = self._period.mean
        self._period.add(interval)
        # Messages that were delayed together have nearly the same stamp, but the robot has moved
        # between them for as long as between any others.
        return max(interval, usual)
