"""Compute a robot's trail, true distance and odometry drift from its poses."""

import math

import numpy
from odometry_common.angles import wrap_to_pi
from sim_turtlebot.geometry import PlanarPose

MAX_SPEED = 5.0  # m/s; a faster step is a reset, as for the movement detector
STAMP_JITTER = 0.05  # s; error of the time between two poses, by their stamps
START_RADIUS = 0.05  # m; an odometry that is closer to zero has just started
TRAIL_SPACING = 0.01  # m
HISTORY_SPACING = 0.1  # s
ORIGIN = PlanarPose(0.0, 0.0, 0.0)


class Samples:
    """At most `limit` rows of numbers, evenly spaced along a run of any length."""

    def __init__(self, spacing, limit=1000):
        self._spacing = spacing
        self._limit = limit
        self._last = -math.inf
        self._rows = []

    def add(self, at, row):
        """Add a row at a time or distance `at`, unless it is too close to the last one."""
        if at - self._last < self._spacing:
            return
        self._last = at
        self._rows.append(row)
        if len(self._rows) > self._limit:
            self._rows = self._rows[::2]
            self._spacing *= 2

    def array(self):
        """Return all rows; NaN for None."""
        return numpy.array(self._rows, dtype=float)


class PathTrace:
    """The path of one robot, by ground truth if there is any, else by odometry."""

    def __init__(self):
        self._restart()

    def _restart(self):
        self.origin = ORIGIN  # of the odometry, in the frame of the path
        self.true_distance = None  # m, along the path
        self._true_start = None  # true pose from which that counts
        self.since = None  # the time (s) from which it counts, if that is not the odometry's start
        self.drift = ORIGIN  # from the odometry's pose to the true one
        self.trail = Samples(TRAIL_SPACING)  # x, y (m)
        self.history = Samples(HISTORY_SPACING)  # as add_history() adds them
        self._heading = 0.0  # rad, of the odometry, continuous
        self._travelled = 0.0
        self._first_stamp = self._odometry = self._ground_truth = None  # the last two with a pose

    @property
    def true_from_start(self):
        """The true distance (m) straight from the start, or where counting began; None: unknown."""
        return self._true_start and _distance(self._true_start, self._ground_truth[1])

    def add_odometry(self, stamp, pose):
        """Add the odometry's PlanarPose at `stamp` (s)."""
        if _is_reset(self._odometry, stamp, pose):
            self._restart()
        if self._odometry is None:
            self._first_stamp = stamp
        self._heading += wrap_to_pi(pose.yaw - self._heading)
        if self._ground_truth is None:
            self._trace(self._odometry, pose)
        self._odometry = stamp, pose
        self._compare()

    def add_ground_truth(self, stamp, pose):
        """Add the true PlanarPose at `stamp` (s)."""
        if _is_reset(self._ground_truth, stamp, pose):
            self._restart()
        if self._ground_truth is None:
            self.trail = Samples(TRAIL_SPACING)
        elif self.true_distance is not None:
            self.true_distance += _distance(self._ground_truth[1], pose)
        self._trace(self._ground_truth, pose)
        self._ground_truth = stamp, pose
        self._compare()

    def add_history(self, moved, target):
        """Add time (s), moved and true distance (m), heading and target (degrees) to the history.

        :param target: heading to turn to (degrees) or None; whole turns are added to bring it
            nearest to the heading
        """
        time, heading = self._odometry[0] - self._first_stamp, math.degrees(self._heading)
        if target is not None:
            target = heading + math.remainder(target - heading, 360)
        self.history.add(time, [time, moved, self.true_distance, heading, target])

    def _trace(self, last, pose):
        if last is not None:
            self._travelled += _distance(last[1], pose)
        self.trail.add(self._travelled, (pose.x, pose.y))

    def _compare(self):
        """Compare odometry and ground truth if both have the same stamp."""
        if not self._odometry or not self._ground_truth:
            return
        (stamp, odometry), (true_stamp, ground_truth) = self._odometry, self._ground_truth
        if stamp != true_stamp:
            return
        if self.true_distance is None:
            self.origin = ground_truth.then(odometry.inverse())
            # If the robot has driven before, its odometry may only show that the wheels slipped.
            self.true_distance = _distance(ORIGIN, odometry)
            if self.true_distance > START_RADIUS:
                self.true_distance, self.since = 0.0, stamp
            self._true_start = self.origin if self.since is None else ground_truth
        self.drift = self.origin.then(odometry).inverse().then(ground_truth)


def _is_reset(last, stamp, pose):
    """Return whether time went back, or the robot jumped, since the last stamp and pose."""
    if last is None:
        return False
    passed = stamp - last[0]
    return _distance(last[1], pose) > MAX_SPEED * (passed + STAMP_JITTER)


def _distance(one, other):
    return math.hypot(other.x - one.x, other.y - one.y)
