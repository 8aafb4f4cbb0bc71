"""What must hold at every step: the distance is the sum, and the odometry is the truth."""

import math

from odometry_common.geometry import PlanarPose, planar_pose

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
        self._origin = self._truth = PlanarPose(0.0, 0.0, 0.0)

    def reset(self):
        """Take note that the odometry has been told to start from zero."""
        self._origin = self._truth

    def check(self, odometry, truth):
        """Compare two messages of the same step."""
        self._truth, seen = planar_pose(truth.pose.pose), planar_pose(odometry.pose.pose)
        expected = self._origin.inverse().then(self._truth)
        x, y, yaw = (one - other for one, other in zip(seen, expected))
        if max(abs(x), abs(y), abs(math.remainder(yaw, math.tau))) > POSE_TOLERANCE:
            raise Violation(f'the odometry is {seen}, and the truth seen from its origin is '
                            f'{expected}')


def _published(total):
    return total if total >= SMALLEST_DISTANCE else 0.0
