"""Decide how fast to drive, from the moved distance."""

import math

from odometry_common.parameters import Parameter, Parameters

PARAMETERS = Parameters(
    Parameter('~distance', 2.0, 'where to stop', 'm', 'above 0'),
    Parameter('~speed', 0.1, 'how fast; negative drives backwards', 'm/s', 'other than 0'),
    Parameter('~relative', False, "count from the first message, not from the detector's start"),
    Parameter('~exit_when_done', False,
              'exit once the robot has stopped; false: keep commanding zero'),
    Parameter('~timeout', 1.0,
              'stop and warn while no message arrives for this long '
              '(ROS time, and at least 0.2 s of wall time); 0: never', 's', 'from 0 to 3600'))


class Drive:
    """Decides how fast to drive, from the latest moved distance."""

    def __init__(self, distance, speed, relative=False):
        """Drive `distance` (m) at `speed` (m/s); `relative`: from the first moved distance on."""
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
        elif moved_distance < self._start:  # the count was reset
            self._start = 0.0
        return self.speed if moved_distance - self._start < self.distance else 0.0
