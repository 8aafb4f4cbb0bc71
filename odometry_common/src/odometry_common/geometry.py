"""Angles, orientations and poses in the plane."""

import math
from typing import NamedTuple

from tf.transformations import euler_from_quaternion

# tf normalises for itself, and doing it twice would change the last digits. But it works with the
# square of the length, which can be too small for it or too large for a float.
SHORT, LONG = 1e-3, 1e3


class PlanarPose(NamedTuple):
    """A pose in the plane."""

    x: float  # m
    y: float  # m
    yaw: float  # rad

    def then(self, other):
        """Return where `other`, a pose relative to this one, is."""
        cosine, sine = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(self.x + cosine * other.x - sine * other.y,
                          self.y + sine * other.x + cosine * other.y,
                          self.yaw + other.yaw)

    def inverse(self):
        """Return where the origin is, seen from this pose."""
        return PlanarPose(0.0, 0.0, -self.yaw).then(PlanarPose(-self.x, -self.y, 0.0))


def planar_pose(pose):
    """Return the PlanarPose of a geometry_msgs/Pose; errors as euler_from_orientation()'s."""
    return PlanarPose(pose.position.x, pose.position.y, yaw_from_orientation(pose.orientation))


def yaw_from_orientation(orientation):
    """Return the yaw (rad, from -pi to pi); the rest is as in euler_from_orientation()."""
    return euler_from_orientation(orientation)[2]


def euler_from_orientation(orientation):
    """Return (roll, pitch, yaw) in radians of a geometry_msgs/Quaternion of any length.

    :raises ValueError: if it is not finite or has no length, and so is not a rotation
    """
    x, y, z, w = orientation.x, orientation.y, orientation.z, orientation.w
    length = math.hypot(x, y, z, w)
    if not math.isfinite(length) or length == 0:
        raise ValueError(f'the quaternion [{x} {y} {z} {w}] is no rotation')
    if not SHORT < length < LONG:
        x, y, z, w = x / length, y / length, z / length, w / length
    return euler_from_quaternion([x, y, z, w])


def wrap_to_pi(angle):
    """Return the same angle (rad) in (-pi, pi]."""
    wrapped = math.remainder(angle, 2 * math.pi)
    return math.pi if wrapped == -math.pi else wrapped
