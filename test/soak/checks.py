"""What must hold at every step: the distance is the sum, and the odometry is the truth."""

import math
from typing import NamedTuple

from tf.transformations import euler_from_quaternion

MAX_SPEED = 5.0  # m/s, the detector's ~max_speed
SMALLEST_DISTANCE = 1e-6  # m
POSE_TOLERANCE = 1e-9  # m and rad


class Violation(AssertionError):
    """Something that must hold does not; the message says what."""


class DistanceCheck:
    """The sum of one detector's steps, computed here once more, without the detector's own code."""

    def __init__(self):
        self._total = 0.0
        self._last = None

    def reset(self):
        self._total = 0.0

    def check(self, odometry, distance):
        """Compare what the detector has said (m) with the sum, bit for bit."""
        self._total += self._step_to(odometry)
        if distance != _published(self._total):
            raise Violation(f'/moved_distance is {distance!r}, and the sum of the steps is '
                            f'{_published(self._total)!r}')

    def _step_to(self, odometry):
        position, stamp = odometry.pose.pose.position, odometry.header.stamp.to_sec()
        last, self._last = self._last, (position.x, position.y, stamp)
        if last is None or stamp < last[2]:
            return 0.0
        step = math.hypot(position.x - last[0], position.y - last[1])
        return step if step / MAX_SPEED <= stamp - last[2] else 0.0


class PoseCheck:
    """The world odometry against the truth, seen from where the odometry has begun."""

    def __init__(self):
        self.start()

    def start(self):
        """Take note that the simulation has been reset."""
        self._origin = self._truth = Pose(0.0, 0.0, 0.0)

    def reset(self):
        """Take note that the odometry has been told to start from zero."""
        self._origin = self._truth

    def check(self, odometry, truth):
        """Compare two messages of the same step."""
        self._truth, seen = pose_of(truth), pose_of(odometry)
        expected = self._truth.seen_from(self._origin)
        if seen.distance_to(expected) > POSE_TOLERANCE:
            raise Violation(f'the odometry is {seen}, and the truth seen from its origin is '
                            f'{expected}')


class Pose(NamedTuple):
    """A place in the plane."""

    x: float  # m
    y: float  # m
    yaw: float  # rad

    def seen_from(self, origin):
        """Return this pose in the frame of another one."""
        x, y = self.x - origin.x, self.y - origin.y
        cos, sin = math.cos(origin.yaw), math.sin(origin.yaw)
        return Pose(x * cos + y * sin, y * cos - x * sin, self.yaw - origin.yaw)

    def distance_to(self, other):
        """Return the largest difference (m or rad)."""
        turned = math.remainder(self.yaw - other.yaw, math.tau)
        return max(abs(self.x - other.x), abs(self.y - other.y), abs(turned))


def pose_of(message):
    """Return the Pose in an Odometry."""
    position, orientation = message.pose.pose.position, message.pose.pose.orientation
    quaternion = [orientation.x, orientation.y, orientation.z, orientation.w]
    return Pose(position.x, position.y, euler_from_quaternion(quaternion)[2])


def _published(total):
    return total if total >= SMALLEST_DISTANCE else 0.0
