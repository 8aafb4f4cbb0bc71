"""Poses in the plane, and rotations as unit quaternions (x, y, z, w).

In double precision and without ROS: PyBullet's own functions use single precision, in which a robot
far from the origin trembles by a millimetre; tf's need rospy.
"""

import math
from typing import NamedTuple

UPRIGHT = 0.5  # cosine of 60 degrees; a TurtleBot that leans more tips over


class PlanarPose(NamedTuple):
    """A pose in the plane."""

    x: float  # m
    y: float  # m
    yaw: float  # rad

    def then(self, other):
        """Return `other`, a pose relative to this one, in the frame of this one."""
        cosine, sine = math.cos(self.yaw), math.sin(self.yaw)
        return PlanarPose(self.x + cosine * other.x - sine * other.y,
                          self.y + sine * other.x + cosine * other.y,
                          self.yaw + other.yaw)

    def inverse(self):
        """Return the pose of the origin relative to this pose."""
        return PlanarPose(0.0, 0.0, -self.yaw).then(PlanarPose(-self.x, -self.y, 0.0))


def about_z(yaw):
    """Return the rotation by a yaw (rad)."""
    return 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)


def about(axis, angle):
    """Return the rotation by an angle (rad) about an axis (three numbers of length 1)."""
    x, y, z = (math.sin(angle / 2) * part for part in axis)
    return x, y, z, math.cos(angle / 2)


def from_rpy(roll, pitch, yaw):
    """Return the rotation by a URDF's roll, pitch and yaw (rad), about fixed axes x, y and z."""
    return compose(about_z(yaw), compose(about((0, 1, 0), pitch), about((1, 0, 0), roll)))


def yaw_of(rotation):
    """Return the yaw (rad), from -pi to pi."""
    x, y, z, w = rotation
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def height_of_z(rotation):
    """Return the z of a rotated unit vector along z: 1 upright, 0 lying, -1 upside down."""
    x, y, _, _ = rotation
    return 1 - 2 * (x * x + y * y)


def is_upright(rotation):
    """Return whether a body with this rotation leans less than 60 degrees."""
    return height_of_z(rotation) > UPRIGHT


def inverse(rotation):
    """Return the inverse rotation."""
    x, y, z, w = rotation
    return -x, -y, -z, w


def canonical(rotation):
    """Return the same rotation with w >= 0: the other quaternion of each is its negative."""
    x, y, z, w = rotation
    return (-x, -y, -z, -w) if w < 0 else rotation


def compose(outer, inner):
    """Return the rotation that does `inner` first and then `outer`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = outer, inner
    return (aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz)


def rotate(rotation, vector):
    """Return the vector (three numbers) turned by the rotation."""
    (x, y, z, w), (a, b, c) = rotation, vector
    # Twice the cross product of axis and vector: faster than two quaternion products.
    d, e, f = 2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)
    return a + w * d + y * f - z * e, b + w * e + z * d - x * f, c + w * f + x * e - y * d


def mean_twist(before, after, duration):
    """Return the constant velocity that leads from one pose to another in `duration` seconds.

    Exact if the robot turns about an axis perpendicular to its motion, as on a floor.

    :param before, after: position (three numbers; m) and orientation, less than half a turn apart
    :return: linear (m/s) and angular (rad/s) velocity in the robot's own frame, three of each
    """
    (start, orientation), (end, turned) = before, after
    x, y, z, w = canonical(compose(inverse(orientation), turned))
    sine = math.hypot(x, y, z)  # of half the angle
    # arc / chord equals angle / sine.
    scale = (math.asin(min(1.0, sine)) / sine if sine else 1.0) / duration
    half = math.hypot(sine, 1 + w)
    halfway = compose(orientation, (x / half, y / half, z / half, (1 + w) / half))
    chord = end[0] - start[0], end[1] - start[1], end[2] - start[2]
    forwards, aside, up = rotate(inverse(halfway), chord)
    return ((scale * forwards, scale * aside, scale * up),
            (2 * scale * x, 2 * scale * y, 2 * scale * z))
