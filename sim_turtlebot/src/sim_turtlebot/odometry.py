"""Where the robot is, and where it believes it is."""

import math
import random
from typing import NamedTuple

from odometry_common.geometry import about_z, compose, inverse, mean_twist, rotate, yaw_of
from odometry_common.kobuki import TICKS_PER_TURN, WHEEL_RADIUS, WHEEL_SEPARATION

from sim_turtlebot.gyro import Gyro

STILL = (0.0, 0.0, 0.0)
LONGEST_MEAN = 0.1  # s; the mean velocity of a longer time says little of the present one


class Motion(NamedTuple):
    """A pose in a fixed frame, and the velocity of the base in its own frame."""

    position: tuple  # x, y, z; m
    orientation: tuple  # quaternion x, y, z, w
    linear: tuple  # x, y, z; m/s
    angular: tuple  # about x, y, z; rad/s


def true_motion(body):
    """Return the Motion of a sim_turtlebot.turtlebot.TurtleBot in the world."""
    position, orientation = body.pose()
    linear, angular = body.velocity()
    to_base = inverse(orientation)
    return Motion(position, orientation, rotate(to_base, linear), rotate(to_base, angular))


class WorldOdometry:
    """The true motion, as a simulator's drive plugin reports it, from a start at zero.

    The velocity is the mean since the last message, as a Kobuki's driver reports it. A robot that
    tips onto its rear caster loses its grip for a hundredth of a second: its velocity at that very
    moment may be half of what it is before and after.
    """

    # The diagonal for x, y, z, roll, pitch, yaw that the tutorial's /odom shows.
    covariance = (1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001)

    def __init__(self, gyro=None):
        """Take the Gyro that is to sense the robot's rotation too, if any."""
        self.gyro = gyro

    def reset(self, ground_truth, _wheel_angles=None):
        """Call this place zero; return the Motion in the odom frame."""
        self._origin = ground_truth.position[:2]
        self._to_odom = about_z(-yaw_of(ground_truth.orientation))
        self._last = ground_truth
        if self.gyro:
            self.gyro.reset(ground_truth.orientation)
        return self._in_odom(ground_truth, ground_truth[2:])

    def update(self, ground_truth, _read_angles, duration):
        """Return the Motion in the odom frame, `duration` seconds after the last call."""
        if self.gyro:
            self.gyro.update(ground_truth.orientation, duration)
        last, self._last = self._last, ground_truth
        twist = ground_truth[2:]
        if twist != (STILL, STILL) and duration <= LONGEST_MEAN:
            twist = mean_twist(last[:2], ground_truth[:2], duration)
        return self._in_odom(ground_truth, twist)

    def _in_odom(self, ground_truth, twist):
        x, y, z = ground_truth.position
        from_origin = x - self._origin[0], y - self._origin[1], z
        return Motion(rotate(self._to_odom, from_origin),
                      compose(self._to_odom, ground_truth.orientation), *twist)

    def carry(self, ground_truth):
        """Return the Motion in the odom frame of a robot that was put down elsewhere."""
        if self.gyro:
            self.gyro.carry(ground_truth.orientation)
        self._last = ground_truth
        return self._in_odom(ground_truth, (STILL, STILL))


class EncoderOdometry:
    """Dead reckoning from wheel ticks, with the errors of a real base."""

    def __init__(self, gyro=True, wheel_slip=0.0, wheel_noise=0.0, gyro_noise=0.0, gyro_drift=0.0,
                 seed=0):
        """Choose the errors; all are off by default.

        :param gyro: take the yaw from the gyro, as kobuki_node's use_imu_heading does by default;
            else from the wheels
        :param wheel_slip: share of each wheel's travel that does not move the robot
        :param wheel_noise: standard deviation of a wheel's travel after one metre (m);
            it grows with the square root of the travel
        :param gyro_noise, gyro_drift: as for a Gyro
        """
        self._use_gyro = gyro
        self._grip = 1.0 / (1.0 - wheel_slip)
        self._wheel_noise = wheel_noise
        self._rng = random.Random(seed)
        self.gyro = Gyro(gyro_noise, gyro_drift, self._rng)
        # kobuki_node/odometry.cpp: yaw is 0.05 with the gyro, 0.2 without; 1e10 means unknown.
        self.covariance = (0.1, 0.1, 1e10, 1e10, 1e10, 0.05 if gyro else 0.2)

    def reset(self, ground_truth, wheel_angles=None):
        """Call this place zero; return the Motion in the odom frame.

        :param wheel_angles: of the left and right wheel (rad); None: as at the last update
        """
        self._x = self._y = self._yaw = 0.0
        if wheel_angles:
            self._ticks = [_ticks(angle) for angle in wheel_angles]
        self.gyro.reset(ground_truth.orientation)
        return Motion((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), STILL, STILL)

    def update(self, ground_truth, read_angles, duration):
        """Return the Motion in the odom frame, `duration` seconds after the last call.

        :param read_angles: function that returns the angles (rad) of the left and right wheel
        """
        left, right = self._wheel_travel(read_angles())
        rotation = self.gyro.update(ground_truth.orientation, duration)
        if not self._use_gyro:
            rotation = (right - left) / WHEEL_SEPARATION
        travel = (left + right) / 2
        self._x += travel * math.cos(self._yaw + rotation / 2)
        self._y += travel * math.sin(self._yaw + rotation / 2)
        self._yaw = math.remainder(self._yaw + rotation, 2 * math.pi)
        return Motion((self._x, self._y, 0.0), about_z(self._yaw),
                      (travel / duration, 0.0, 0.0), (0.0, 0.0, rotation / duration))

    def carry(self, ground_truth):
        """Return the Motion in the odom frame of a robot that was put down elsewhere.

        No wheel has turned, so that it is where it was. Only a gyro notices that it was turned.
        """
        rotation = self.gyro.carry(ground_truth.orientation)
        if self._use_gyro:
            self._yaw = math.remainder(self._yaw + rotation, 2 * math.pi)
        return Motion((self._x, self._y, 0.0), about_z(self._yaw), STILL, STILL)

    def _wheel_travel(self, wheel_angles):
        ticks = [_ticks(angle) for angle in wheel_angles]
        metres = 2 * math.pi * WHEEL_RADIUS / TICKS_PER_TURN
        travels = [(now - before) * metres for now, before in zip(ticks, self._ticks)]
        self._ticks = ticks
        return [self._grip * travel
                + self._rng.gauss(0.0, self._wheel_noise * math.sqrt(abs(travel)))
                for travel in travels]


def _ticks(angle):
    return math.floor(angle / (2 * math.pi) * TICKS_PER_TURN)
