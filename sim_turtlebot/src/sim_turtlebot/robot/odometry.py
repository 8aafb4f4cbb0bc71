"""The true motion of a robot, and its odometry."""

import math
from typing import NamedTuple

from sim_turtlebot.geometry import about_z, canonical, compose, inverse, mean_twist, rotate, yaw_of

STILL = (0.0, 0.0, 0.0)
MAX_MEAN_TIME = 0.1  # s; over a longer time, the mean velocity says little about the current one


class Motion(NamedTuple):
    """A pose in a fixed frame, and the velocity of the base in its own frame."""

    position: tuple  # x, y, z; m
    orientation: tuple  # quaternion x, y, z, w; w >= 0, as kobuki_node sends it
    linear: tuple  # x, y, z; m/s
    angular: tuple  # about x, y, z; rad/s


def true_motion(body):
    """Return the Motion of a sim_turtlebot.physics.turtlebot.TurtleBot in the world."""
    position, orientation = body.pose()
    linear, angular = body.velocity()
    to_base = inverse(orientation)
    return Motion(position, canonical(orientation),
                  rotate(to_base, linear), rotate(to_base, angular))


class WorldOdometry:
    """The true motion relative to the start, as a simulator's drive plugin reports it.

    The velocity is the mean since the last message, as a Kobuki's driver reports it; after more
    than MAX_MEAN_TIME it is the current one. When a robot tips onto its rear caster, its wheels
    slip for 0.01 s, and its velocity at that moment may be half of the velocity before and after.
    """

    # The diagonal for x, y, z (m^2), roll, pitch, yaw (rad^2) that the tutorial's /odom shows.
    covariance = (1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001)
    twist_covariance = (0.0,) * 6

    def reset(self, ground_truth):
        """Set the odom frame to this pose; return the Motion in it."""
        self._origin = ground_truth.position[:2]
        self._to_odom = about_z(-yaw_of(ground_truth.orientation))
        self._last = ground_truth
        return self._in_odom(ground_truth, ground_truth[2:])

    def update(self, ground_truth, duration):
        """Return the Motion in the odom frame, `duration` seconds after the last call."""
        last, self._last = self._last, ground_truth
        twist = ground_truth[2:]
        if twist != (STILL, STILL) and duration <= MAX_MEAN_TIME:
            twist = mean_twist(last[:2], ground_truth[:2], duration)
        return self._in_odom(ground_truth, twist)

    def teleport(self, ground_truth):
        """Return the Motion in the odom frame after ~set_pose has moved the robot."""
        self._last = ground_truth
        return self._in_odom(ground_truth, (STILL, STILL))

    def _in_odom(self, ground_truth, twist):
        x, y, z = ground_truth.position
        from_origin = x - self._origin[0], y - self._origin[1], z
        orientation = compose(self._to_odom, ground_truth.orientation)
        return Motion(rotate(self._to_odom, from_origin), canonical(orientation), *twist)


class EncoderOdometry:
    """Dead reckoning from the last sensor readings; the methods are those of WorldOdometry."""

    def __init__(self, encoders, gyro, geometry, use_gyro):
        """Read Encoders and a Gyro of sim_turtlebot.robot.sensors.

        :param geometry: sim_turtlebot.robot.drive_geometry.DriveGeometry
        :param use_gyro: take the yaw from the gyro, as kobuki_node's use_imu_heading does by
            default; else from the wheels
        """
        self._encoders = encoders
        self._gyro = gyro
        self._geometry = geometry
        self._use_gyro = use_gyro
        # kobuki_node/odometry.cpp: yaw is 0.05 with the gyro, 0.2 without; 1e10 means unknown.
        self.covariance = (0.1, 0.1, 1e10, 1e10, 1e10, 0.05 if use_gyro else 0.2)
        # kobuki_node has zeros, which no filter can use: (3 cm/s)^2, and for yaw as for the
        # pose's sources.
        self.twist_covariance = (0.001, 0.001, 1e10, 1e10, 1e10, 0.005 if use_gyro else 0.02)

    def reset(self, _ground_truth):
        """Set pose and velocity to zero."""
        self._x = self._y = self._yaw = 0.0
        return self._motion(STILL, STILL)

    def update(self, _ground_truth, duration):
        """Add the travel and the rotation of the last period."""
        travel, rotation = self._geometry.motion(*self._encoders.travel)
        if self._use_gyro:
            rotation = self._gyro.rotation
        self._x += travel * math.cos(self._yaw + rotation / 2)
        self._y += travel * math.sin(self._yaw + rotation / 2)
        self._yaw = math.remainder(self._yaw + rotation, 2 * math.pi)
        return self._motion((travel / duration, 0.0, 0.0), (0.0, 0.0, rotation / duration))

    def teleport(self, _ground_truth):
        """Add only the rotation that the gyro measures: no wheel has turned."""
        if self._use_gyro:
            self._yaw = math.remainder(self._yaw + self._gyro.rotation, 2 * math.pi)
        return self._motion(STILL, STILL)

    def _motion(self, linear, angular):
        return Motion((self._x, self._y, 0.0), about_z(self._yaw), linear, angular)
