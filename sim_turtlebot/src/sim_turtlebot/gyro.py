"""The gyro of a Kobuki: its heading, from which the driver takes that of the odometry."""

import math
import random

from odometry_common.geometry import yaw_of


class Gyro:
    """Adds up the robot's rotation, with its errors; also while the robot stands."""

    def __init__(self, noise=0.0, drift=0.0, rng=None):
        """Choose the errors; all are off by default.

        :param noise: angle random walk (rad after one second)
        :param drift: bias (rad/s), what is left of it after the calibration when switched on
        :param rng: random.Random
        """
        self._noise = noise
        self._drift = drift
        self._rng = rng or random.Random(0)

    def reset(self, orientation):
        """Call this orientation (x, y, z, w) heading zero, as the driver does."""
        self.heading = self.rate = 0.0  # rad, from -pi to pi; rad/s
        self._true_yaw = yaw_of(orientation)

    def update(self, orientation, duration):
        """Sense the rotation since the last call, `duration` seconds ago; return it (rad)."""
        rotation = self._true_rotation(orientation)
        rotation += self._rng.gauss(self._drift * duration, self._noise * math.sqrt(duration))
        self.heading = math.remainder(self.heading + rotation, 2 * math.pi)
        self.rate = rotation / duration
        return rotation

    def carry(self, orientation):
        """Sense the rotation of a robot that was put down elsewhere, in no time; return it (rad)."""
        rotation = self._true_rotation(orientation)
        self.heading = math.remainder(self.heading + rotation, 2 * math.pi)
        self.rate = 0.0
        return rotation

    def _true_rotation(self, orientation):
        """Return the rotation since the last call (rad)."""
        before, self._true_yaw = self._true_yaw, yaw_of(orientation)
        return math.remainder(self._true_yaw - before, 2 * math.pi)
