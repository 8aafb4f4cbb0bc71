"""Where the page draws what a scan has met."""

import math

import numpy
import pytest
from odometry_common.kobuki import DEPTH_CAMERA
from robot_view.monitor import scan_points
from sensor_msgs.msg import LaserScan


def scan(*ranges, frame='camera_depth_frame'):
    message = LaserScan(ranges=ranges, angle_min=-math.pi / 2, angle_increment=math.pi / 2,
                        range_min=0.5, range_max=4.0)
    message.header.frame_id = frame
    return message


@pytest.mark.parametrize('frame', ['camera_depth_frame', '/camera_depth_frame',
                                   'robot_2/camera_depth_frame'])
def test_each_range_is_a_point_seen_from_the_camera(frame):
    expected = numpy.array([(0, -1, 0), (2, 0, 0), (0, 4, 0)]) + DEPTH_CAMERA
    assert scan_points(scan(1.0, 2.0, 4.0, frame=frame)) == pytest.approx(expected)


@pytest.mark.parametrize('nothing', [math.inf, -math.inf, math.nan, 0.4, 4.1, -1.0])
def test_where_nothing_was_seen_there_is_no_point(nothing):
    assert scan_points(scan(nothing, 2.0, nothing)) == pytest.approx(
        numpy.array([(2, 0, 0)]) + DEPTH_CAMERA)
    assert scan_points(scan(nothing, nothing, nothing)).shape == (0, 3)


def test_a_scan_of_unknown_origin_has_no_points():
    assert scan_points(scan(1.0, 2.0, 3.0, frame='laser')).shape == (0, 3)


@pytest.mark.parametrize('field', ['angle_min', 'angle_increment', 'range_max'])
@pytest.mark.parametrize('value', [math.nan, math.inf])
def test_every_point_is_finite(field, value):
    message = scan(1.0, math.inf, 3.0)
    setattr(message, field, value)
    assert numpy.isfinite(scan_points(message)).all()
