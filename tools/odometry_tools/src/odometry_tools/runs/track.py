"""The path of a robot, from the odometry messages in a bag."""

import math
from typing import NamedTuple

import numpy
from geometry_msgs.msg import Quaternion
from moved_distance.distance_counter import DistanceCounter
from odometry_common.orientation import yaw_from_orientation
from sim_turtlebot.geometry import PlanarPose

RESTART = 1.0  # s by which time goes back


class Track(NamedTuple):
    """Odometry messages as arrays of the same length."""

    time: numpy.ndarray  # s since the first message of the run
    x: numpy.ndarray  # m
    y: numpy.ndarray  # m
    yaw: numpy.ndarray  # rad, without jumps
    speed: numpy.ndarray  # m/s, forwards; NaN if the driver does not report it
    turn_rate: numpy.ndarray  # rad/s
    distance: numpy.ndarray  # m, as the detector counts it
    jumps: list  # indices of the messages whose step is not counted as movement
    ignored: int  # number of further messages: late, not finite, or before time restarted

    def moved_onto(self, other):
        """Return the same path, moved so that both start at the same pose.

        None if they have no messages of the same time.
        """
        start = max(self.time[0], other.time[0])
        end = min(self.time[-1], other.time[-1])
        if start > end:
            return None
        frame = other.at(start).then(self.at(start).inverse())
        x, y, yaw = frame.then(PlanarPose(self.x, self.y, self.yaw))
        return self._replace(x=x, y=y, yaw=yaw)

    def at(self, time):
        """Return the PlanarPose in the message nearest to a time (s)."""
        nearest = numpy.abs(self.time - time).argmin()
        return PlanarPose(self.x[nearest], self.y[nearest], self.yaw[nearest])


def timed(rows, end):
    """Return pairs of the time (s) of a message, up to an end, and its row in the bag.

    The time is its stamp, or when it was recorded if none of them has a stamp.
    """
    stamps = [row.message.header.stamp.to_sec() if hasattr(row.message, 'header') else 0.0
              for row in rows]
    times = stamps if any(stamps) else [row.timestamp.to_sec() for row in rows]
    return [(time, row) for time, row in zip(times, rows) if time <= end]


def last_restart(messages):
    """Return the index of the message with which time has last restarted, or 0.

    A simulator was reset. A single message that is older than the one before it is late.
    """
    times = [time for time, _ in messages]
    return max((index for index, (before, *two) in enumerate(zip(times, times[1:], times[2:]), 1)
                if max(two) < before - RESTART), default=0)


def track_of(messages, start):
    """Return the Track of those with finite numbers since time restarted; None if there are none.

    :param messages: pairs, as timed() returns them
    :param start: of the run (s)
    """
    counter, kept, jumps = DistanceCounter(), [], []
    for time, row in messages[last_restart(messages):]:
        pose, twist = row.message.pose.pose, row.message.twist.twist
        speed, turn_rate = twist.linear.x, twist.angular.z
        x, y = pose.position.x, pose.position.y
        try:
            not_counted = counter.add(x, y, time, row.timestamp.to_sec())
            yaw = _yaw(pose.orientation)
        except ValueError:  # its position or orientation is not finite
            continue
        is_late = not_counted and kept and time < kept[-1][0]
        if is_late or not math.isfinite(speed):
            continue
        if not_counted:
            jumps.append(len(kept))
        kept.append((time, x, y, yaw, speed, turn_rate, counter.distance))
    if not kept:
        return None
    time, x, y, yaw, speed, turn_rate, distance = numpy.array(kept).T
    if distance[-1] and not speed.any():
        speed[:] = math.nan
    return Track(time - start, x, y, numpy.unwrap(yaw), speed, turn_rate, distance, jumps,
                 len(messages) - len(kept))


def _yaw(orientation):
    """Return the yaw (rad); 0 if the driver leaves the orientation empty."""
    return yaw_from_orientation(orientation) if orientation != Quaternion() else 0.0
