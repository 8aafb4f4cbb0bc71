"""Laser scans as points."""

import numpy
from odometry_common.kobuki import DEPTH_CAMERA, DEPTH_CAMERA_FRAME


def scan_points(message):
    """Return the points of a LaserScan: rows of x, y, z (m) in the frame of the base.

    Ranges that are infinite or NaN, as in REP-117, have no point. Nor have those of another sensor
    than the depth camera, whose place on the robot is unknown.
    """
    if message.header.frame_id.split('/')[-1] != DEPTH_CAMERA_FRAME:
        return numpy.empty((0, 3))
    ranges = numpy.array(message.ranges, dtype=float)
    with numpy.errstate(invalid='ignore'):  # a message may contain any number
        angles = message.angle_min + message.angle_increment * numpy.arange(len(ranges))
        is_seen = (ranges >= message.range_min) & (ranges <= message.range_max)
        points = numpy.column_stack(
            [ranges * numpy.cos(angles), ranges * numpy.sin(angles), numpy.zeros(len(ranges))])
    return points[is_seen & numpy.isfinite(points).all(axis=1)] + DEPTH_CAMERA
