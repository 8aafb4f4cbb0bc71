"""Roll, pitch and yaw of a message's orientation, from tf, as in the tutorial."""

import math

from tf.transformations import euler_from_quaternion

# Outside these lengths tf's square would be 0 or infinite; inside, normalising changes the last
# digits.
SHORT, LONG = 1e-3, 1e3


def yaw_from_orientation(orientation):
    """Return the yaw (rad, from -pi to pi); parameter and error as in euler_from_orientation()."""
    return euler_from_orientation(orientation)[2]


def euler_from_orientation(orientation):
    """Return (roll, pitch, yaw) in radians of a geometry_msgs/Quaternion of any length.

    :raises ValueError: if it is not finite or has no length, and so is not a rotation
    """
    parts = orientation.x, orientation.y, orientation.z, orientation.w
    length = math.hypot(*parts)
    if not math.isfinite(length) or length == 0:
        raise ValueError(f'the quaternion [{" ".join(map(str, parts))}] is no rotation')
    if not SHORT < length < LONG:
        parts = [part / length for part in parts]
    return euler_from_quaternion(parts)
