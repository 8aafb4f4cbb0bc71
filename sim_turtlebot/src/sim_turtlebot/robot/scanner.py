"""The laser scan of a TurtleBot 2's depth camera, by ray casting; no ROS."""

import math

import numpy

from sim_turtlebot.kobuki import DEPTH_CAMERA


class Scanner:
    """Measures the distance to the robot's surroundings along a horizontal fan of beams."""

    def __init__(self, body, settings, index=0):
        """Spread the beams evenly over the field of view; parameters as for a Robot."""
        self._cast_rays = body.cast_rays
        self._beams, self._noise = settings.scan_beams, settings.scan_noise
        self._range_min, self._range_max = settings.scan_range_min, settings.scan_range_max
        self._index = index
        self._share = settings.scan_rate / settings.odom_rate  # scans per odometry
        self.seed = settings.seed  # of the noise
        angles = numpy.linspace(-settings.scan_fov / 2, settings.scan_fov / 2, self._beams)
        directions = numpy.column_stack(
            [numpy.cos(angles), numpy.sin(angles), numpy.zeros(self._beams)])
        self._starts = [DEPTH_CAMERA] * self._beams
        self._ends = (DEPTH_CAMERA + self._range_max * directions).tolist()

    def is_due(self, number):
        """Return whether this odometry period, from 0, is the first at or after a scan's time."""
        # The small term keeps a scan at its odometry despite rounding.
        before, now = (math.floor(count * self._share + 1e-6) for count in (number - 1, number))
        return now > before

    def scan(self, number):
        """Return the ranges (m) from right to left, as REP-117 defines them.

        +inf: nothing up to range_max. -inf: something nearer than range_min.

        :param number: of the odometry period, from 0; it alone seeds the noise, so a repeated scan
            is the same
        """
        shares = numpy.array(self._cast_rays(self._starts, self._ends))
        ranges = self._range_max * shares
        if self._noise:
            # numpy guarantees a stable sequence for this generator only.
            seed = self.seed % 2**32, self._index, number  # none may be negative
            rng = numpy.random.RandomState(seed)
            ranges += rng.normal(0.0, self._noise, self._beams)
        ranges[(shares == 1.0) | (ranges > self._range_max)] = math.inf
        ranges[ranges < self._range_min] = -math.inf
        return ranges
