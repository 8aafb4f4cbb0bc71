"""What the nodes of each tutorial do with odometry, by the nodes' own classes, without ROS."""

import math
from typing import NamedTuple

from heading_control.parameters import read_rate, read_turn
from moved_distance.parameters import read_counter
from odometry_common.geometry import PlanarPose, wrap_to_pi, yaw_from_orientation
from odometry_common.kobuki import MAX_ANGULAR_SPEED, MAX_LINEAR_SPEED
from odometry_common.timing import Metronome
from odometry_launch.arrival import HEADING_TOLERANCE, has_driven, has_turned
from straight_drive.parameters import read_drive

PATIENCE = 1.5  # times as long as a robot takes that does what it is told,
MORE_PATIENCE = 10.0  # s, and so much more, before a run is given up


class Orientation(NamedTuple):
    """A quaternion, as geometry_msgs has it."""

    x: float
    y: float
    z: float
    w: float


class Move:
    """The first tutorial: the detector and the mover."""

    def __init__(self):
        """Read the parameters."""
        self._counter = read_counter()
        self._drive = read_drive()
        self._moved_before = 0.0
        speed = min(abs(self._drive.speed), MAX_LINEAR_SPEED)
        self.longest = PATIENCE * self._drive.distance / speed + MORE_PATIENCE  # s

    def answer(self, stamp, odometry):
        """Return the command (m/s, rad/s) after an odometry (a Motion, s)."""
        self._moved_before = self._counter.distance
        x, y, _ = odometry.position
        self._counter.add(x, y, stamp, stamp)
        return self._drive.speed_at(self._counter.distance), 0.0

    def arrived(self, ground_truth):
        """Return whether the robot (a Motion) has done what it was told."""
        return has_driven(self._counter.distance, self._moved_before, self._drive.distance,
                          ground_truth.linear)

    def figures(self, start, end):
        """Return the figures by their names, without time, from the true first and last Motion."""
        moved, wanted = self._counter.distance, self._drive.distance
        travel = _planar_pose(start).inverse().then(_planar_pose(end))
        true_distance = math.hypot(travel.x, travel.y)
        return {'moved': moved, 'moved_error': moved - wanted,
                'true_distance': true_distance, 'true_error': true_distance - wanted,
                'sideways': travel.y, 'heading': _degrees(travel.yaw)}


class Rotate:
    """The second tutorial: the P-controller on the heading."""

    def __init__(self):
        """Read the parameters."""
        self._turn = read_turn()
        self.rate = read_rate()  # Hz
        self._metronome = Metronome(1 / self.rate)
        self._overshoot = 0.0
        self._direction = None
        # At its limit a robot turns; near the target it creeps, the slower the smaller the gain.
        way = abs(self._turn.error_at(0.0))
        turning = way / min(self._turn.max_angular_speed, MAX_ANGULAR_SPEED)
        creeping = math.log(max(1.0, math.degrees(way) / HEADING_TOLERANCE)) / self._turn.kp
        self.longest = PATIENCE * (turning + creeping) + MORE_PATIENCE  # s

    def answer(self, stamp, odometry):
        """Return the command (m/s, rad/s) after an odometry (a Motion, s), None if none is due."""
        self._yaw = _yaw(odometry)
        self._error = self._turn.error_at(self._yaw)
        if self._direction is None:
            self._direction = math.copysign(1.0, self._error)
        beyond = -self._direction * self._error
        if beyond < math.pi / 2:  # else the target is behind the robot: there errors change sign
            self._overshoot = max(self._overshoot, beyond)
        if not self._metronome.is_due(stamp):
            return None
        return 0.0, self._turn.speed_for(self._error)

    def arrived(self, ground_truth):
        """Return whether the robot (a Motion) has done what it was told."""
        return has_turned(self._error, ground_truth.angular[2])

    def figures(self, start, end):
        """Return the figures by their names, without time, from the true first and last Motion."""
        true_yaw = _yaw(end) - _yaw(start)
        return {'heading': _degrees(self._yaw), 'heading_error': math.degrees(-self._error),
                'true_heading': _degrees(true_yaw),
                'true_error': math.degrees(-self._turn.error_at(true_yaw)),
                'overshoot': math.degrees(self._overshoot)}


TUTORIALS = {'move': Move, 'rotate': Rotate}


def _planar_pose(motion):
    return PlanarPose(*motion.position[:2], _yaw(motion))


def _yaw(motion):
    return yaw_from_orientation(Orientation(*motion.orientation))


def _degrees(angle):
    return math.degrees(wrap_to_pi(angle))
