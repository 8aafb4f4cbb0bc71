"""Rotations as unit quaternions (x, y, z, w).

PyBullet's functions for these compute in single precision, which makes a robot far from the origin
tremble by a millimetre; tf's import rospy, which the simulation does without.
"""

import math

UPRIGHT = 0.5  # cosine of 60 degrees, from which on a TurtleBot has fallen, or will


def about_z(yaw):
    """Return the rotation by a yaw (rad)."""
    return 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)


def yaw_of(rotation):
    """Return the yaw (rad), from -pi to pi."""
    x, y, z, w = rotation
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def height_of_z(rotation):
    """Return how high a unit vector along z still is: 1 upright, 0 lying, -1 upside down."""
    x, y, _, _ = rotation
    return 1 - 2 * (x * x + y * y)


def is_upright(rotation):
    """Return whether what is rotated leans less than 60 degrees from the vertical."""
    return height_of_z(rotation) > UPRIGHT


def inverse(rotation):
    """Return the rotation back."""
    x, y, z, w = rotation
    return -x, -y, -z, w


def compose(outer, inner):
    """Return the rotation that does `inner` first and then `outer`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = outer, inner
    return (aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz)


def rotate(rotation, vector):
    """Return the vector (three numbers) turned by the rotation."""
    return compose(compose(rotation, (*vector, 0.0)), inverse(rotation))[:3]
