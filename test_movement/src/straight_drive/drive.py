"""The speed to command after a distance."""

import math


class Drive:
    """Decides how fast to go from the latest moved distance."""

    def __init__(self, distance, speed, relative=False):
        """Go at `speed` (m/s) for `distance` (m), from zero or from the first distance seen."""
        self.distance = distance
        self.speed = speed
        self._start = None if relative else 0.0

    def speed_at(self, moved_distance):
        """Return the speed to command (m/s) after `moved_distance` (m).

        :raises ValueError: if moved_distance is not finite
        """
        if not math.isfinite(moved_distance):
            raise ValueError(f'the moved distance {moved_distance} is not finite')
        if self._start is None:
            self._start = moved_distance
        return self.speed if moved_distance - self._start < self.distance else 0.0
