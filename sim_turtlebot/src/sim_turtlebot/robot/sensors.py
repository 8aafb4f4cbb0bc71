"""The sensors of a Kobuki's odometry: wheel encoders and gyro, with their errors."""

import math

from sim_turtlebot.geometry import yaw_of
from sim_turtlebot.kobuki import TICKS_PER_TURN, WHEEL_RADIUS

METRES_PER_TICK = 2 * math.pi * WHEEL_RADIUS / TICKS_PER_TURN


class Encoders:
    """Counts the ticks of the left and right wheel."""

    def __init__(self, settings, rng):
        """Start without a reading; reset() takes the first.

        :param settings: of sim_turtlebot.settings.read_settings()
        :param rng: random.Random
        """
        self._grip = 1.0 / (1.0 - settings.wheel_slip)
        self._noise = settings.wheel_noise
        self._rng = rng

    def reset(self, wheel_angles):
        """Start counting at these angles (rad)."""
        self._ticks = [_ticks(angle) for angle in wheel_angles]
        self.travel = 0.0, 0.0  # m, of each wheel in the last odometry period

    def update(self, wheel_angles):
        """Measure the travel of each wheel since the last call; angles in rad."""
        before, self._ticks = self._ticks, [_ticks(angle) for angle in wheel_angles]
        self.travel = tuple(self._measured((ticks - last) * METRES_PER_TICK)
                            for ticks, last in zip(self._ticks, before))

    def _measured(self, travel):
        # The noise grows with the square root of the travel.
        return self._grip * travel + self._rng.gauss(0.0, self._noise * math.sqrt(abs(travel)))


class Gyro:
    """Integrates the robot's rotation, also at rest."""

    def __init__(self, settings, rng):
        """Start without a reading; parameters as for Encoders."""
        self._noise, self._drift = settings.gyro_noise, settings.gyro_drift
        self._scale = 1.0 + settings.gyro_scale_error
        self._correction = settings.gyro_scale_correction
        self._rng = rng

    def reset(self, orientation):
        """Set the heading to zero at this orientation (x, y, z, w), as the driver does."""
        self.heading = self.rate = 0.0  # rad, from -pi to pi; rad/s
        self.rotation = 0.0  # rad, measured by the last update
        self._true_yaw = yaw_of(orientation)

    def update(self, orientation, duration):
        """Measure the rotation since the last call, `duration` seconds ago."""
        error = self._rng.gauss(self._drift * duration, self._noise * math.sqrt(duration))
        self._turn(orientation, error)
        self.rate = self.rotation / duration

    def teleport(self, orientation):
        """Measure the rotation after ~set_pose has moved the robot."""
        self._turn(orientation, 0.0)
        self.rate = 0.0

    def _turn(self, orientation, error):
        before, self._true_yaw = self._true_yaw, yaw_of(orientation)
        rotation = math.remainder(self._true_yaw - before, 2 * math.pi)
        self.rotation = self._correction * (self._scale * rotation + error)
        self.heading = math.remainder(self.heading + self.rotation, 2 * math.pi)


def _ticks(angle):
    return math.floor(angle / (2 * math.pi) * TICKS_PER_TURN)
