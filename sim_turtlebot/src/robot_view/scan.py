"""Laser scans as points, where a robot has seen something."""

from typing import NamedTuple

import numpy
from odometry_common.kobuki import DEPTH_CAMERA, DEPTH_CAMERA_FRAME


class Scan(NamedTuple):
    """A scan, and where the robot was then."""

    pose: tuple  # robots.Pose3D
    points: numpy.ndarray  # rows of x, y, z (m) in the frame of the base


def scan_points(message):
    """Return the points of a LaserScan: rows of x, y, z (m) in the frame of the base.

    There are none for ranges that are infinite or no number, as REP-117 has them, nor for those of
    a sensor that is not the depth camera: nobody says where on the robot it is.
    """
    if message.header.frame_id.split('/')[-1] != DEPTH_CAMERA_FRAME:
        return numpy.empty((0, 3))
    ranges = numpy.array(message.ranges, dtype=float)
    with numpy.errstate(invalid='ignore'):  # whatever a message says
        angles = message.angle_min + message.angle_increment * numpy.arange(len(ranges))
        is_seen = (ranges >= message.range_min) & (ranges <= message.range_max)
        points = numpy.column_stack(
            [ranges * numpy.cos(angles), ranges * numpy.sin(angles), numpy.zeros(len(ranges))])
    return points[is_seen & numpy.isfinite(points).all(axis=1)] + DEPTH_CAMERA
