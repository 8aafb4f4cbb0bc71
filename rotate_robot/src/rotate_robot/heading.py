"""Headings: out of a quaternion, apart by the shorter way, and the turn towards a target."""

import math

from tf.transformations import euler_from_quaternion

# tf normalises for itself, and doing it twice would change the last digits. But it works with the
# square of the length, which can be too small for it or too large for a float.
SHORT, LONG = 1e-3, 1e3


def euler_from_orientation(orientation):
    """Return (roll, pitch, yaw) in radians of a geometry_msgs/Quaternion of any length.

    :raises ValueError: if it is not finite or has no length, and so means no rotation
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


def turn_command(error, kp, max_angular_speed):
    """Return the angular velocity (rad/s) of a P-controller on the heading.

    :param error: wanted minus actual heading (rad), wrapped so that the shorter way is taken
    :param kp: gain (1/s)
    :param max_angular_speed: limit of the result (rad/s)
    """
    return max(-max_angular_speed, min(max_angular_speed, kp * error))
