"""What must hold at every step: the distance is the sum, and the odometry is the truth."""

import math
from typing import NamedTuple

from sim_turtlebot.rotations import yaw_of

MAX_SPEED = 5.0  # m/s, the detector's ~max_speed
SMALLEST_DISTANCE = 1e-6  # m
STEPS_TO_OBEY = 150  # for a reset that is sent while everything goes on; events are further apart
POSE_TOLERANCE = 1e-9  # m and rad


class Violation(AssertionError):
    """Something that must hold does not; the message says what."""


class Request:
    """A reset that was asked for and shows at one of the next steps."""

    def __init__(self, name):
        """Name it for the user; none is open."""
        self._name = name
        self._left = 0
        self._shows = False

    def open(self, shows):
        """Expect it from now on; `shows`: whether its coming can be seen for sure."""
        self._left, self._shows = STEPS_TO_OBEY, shows

    def close(self):
        """Tell whether it was open, and expect it no more."""
        was_open, self._left = self._left > 0, 0
        return was_open

    def count_step(self):
        """Let a step pass in which it has not shown.

        :raises Violation: if it was the last one in which it may come
        """
        self._left -= 1
        if self._left == 0 and self._shows:
            raise Violation(f'{self._name} has not come within {STEPS_TO_OBEY} steps')


class DistanceCheck:
    """The sum of one detector's steps, computed here once more."""

    def __init__(self):
        """Begin with a detector that has not heard anything yet."""
        self._total = 0.0
        self._last = None
        self._reset = Request('the reset of the distance')

    def expect_reset(self):
        """Take note of a reset that was sent to the detector."""
        self._reset.open(shows=_published(self._total) > 0)

    def check(self, odometry, distance):
        """Compare what the detector has said (m) with the sum, bit for bit."""
        step = self._step_to(odometry)
        self._total += step
        if distance == _published(self._total):
            self._reset.count_step()
        elif distance == _published(step) and self._reset.close():
            self._total = step
        else:
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
        """Begin with a robot at its start."""
        self._reset = Request('the reset of the odometry')
        self.start()

    def start(self):
        """Take note that the simulation has been reset."""
        self._origin = self._truth = self._odometry = Pose(0.0, 0.0, 0.0)
        self._reset.close()

    def expect_reset(self):
        """Take note of a reset that was sent to the simulator."""
        self._reset.open(shows=self._odometry.distance_to(Pose(0.0, 0.0, 0.0)) > POSE_TOLERANCE)

    def check(self, odometry, truth):
        """Compare two messages of the same step."""
        self._odometry, before, self._truth = pose_of(odometry), self._truth, pose_of(truth)
        if self._agrees(self._origin):
            self._reset.count_step()
        elif self._agrees(before) and self._reset.close():
            self._origin = before
        else:
            raise Violation(f'the odometry is {self._odometry}, and the truth seen from its '
                            f'origin is {self._truth.seen_from(self._origin)}')

    def _agrees(self, origin):
        return self._odometry.distance_to(self._truth.seen_from(origin)) <= POSE_TOLERANCE


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
        turn = math.remainder(self.yaw - other.yaw, math.tau)
        return max(abs(self.x - other.x), abs(self.y - other.y), abs(turn))


def pose_of(message):
    """Return the Pose in an Odometry."""
    position, turn = message.pose.pose.position, message.pose.pose.orientation
    return Pose(position.x, position.y, yaw_of((turn.x, turn.y, turn.z, turn.w)))


def _published(total):
    return total if total >= SMALLEST_DISTANCE else 0.0
