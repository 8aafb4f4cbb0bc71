"""Detect that a robot is at rest, from its speeds, its distance or its heading."""

import math

LINEAR_SPEED, ANGULAR_SPEED = 1e-3, 1e-2  # m/s, rad/s; well above the creep with idle motors
DISTANCE_BAND, ANGLE_BAND = 1e-3, math.radians(0.1)  # m, rad; a robot at rest stays within these
DURATION = 0.5  # s, for this long


def is_slow(linear, angular=0.0):
    """Return whether speeds (m/s, rad/s; numbers or arrays) are those of a robot at rest."""
    return (abs(linear) < LINEAR_SPEED) & (abs(angular) < ANGULAR_SPEED)


class RestDetector:
    """Notices when a measured value stops changing."""

    def __init__(self, band):
        """At rest, the value stays within `band` for DURATION."""
        self._band = band
        self.reset()

    def reset(self):
        """Forget earlier values."""
        self._value, self._since = math.nan, 0.0

    def at_rest(self, now, value):
        """Add the `value` measured at `now` (s); return whether it is at rest."""
        if not abs(value - self._value) <= self._band or now < self._since:
            self._value, self._since = value, now
        return now - self._since >= DURATION
