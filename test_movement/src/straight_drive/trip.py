"""How far the robot has moved since a trip began."""

import math


class Trip:
    """The robot's path since the trip began."""

    def __init__(self, relative=False):
        """Begin at a moved distance of zero, or, if `relative`, at the first one seen."""
        self._start = None if relative else 0.0

    def length(self, moved_distance):
        """Return how far the robot has come (m) at `moved_distance` (m).

        :raises ValueError: if moved_distance is not finite
        """
        if not math.isfinite(moved_distance):
            raise ValueError(f'the moved distance {moved_distance} is not finite')
        if self._start is None:
            self._start = moved_distance
        return moved_distance - self._start
