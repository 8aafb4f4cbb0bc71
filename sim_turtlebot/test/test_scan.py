"""The laser scan over ROS: what a client gets, and when there is nobody to get it."""

import math

import pytest
import rosgraph
from nav_msgs.msg import Odometry
from odometry_tests.scripts import ROOT
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder, wait_until
from sensor_msgs.msg import LaserScan

ROOM = f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf'
CORRIDOR = f'_world:={ROOT}/sim_turtlebot/worlds/corridor.urdf'
SCANS = 20
UNPACED = '_real_time_factor:=0'  # and without a queue from which messages could drop


def test_without_the_parameter_there_is_no_scan(simulated_time):
    with simulator():
        Recorder('odom', Odometry).wait_for()
        assert '/scan' not in dict(rosgraph.Master('/test').getSystemState()[0])


def test_a_scan_is_that_of_the_depth_camera(simulated_time):
    """640 beams in 60 degrees, ten times a second, each with an odometry of the same moment."""
    with simulator('_scan:=true', CORRIDOR, UNPACED):
        odometry = Recorder('odom', Odometry)
        odometry.wait_for()  # connected before the first scan
        scans = Recorder('scan', LaserScan)
        seen = scans.wait_for_count(SCANS)
        wait_until(lambda: odometry.last.header.stamp > seen[-1].header.stamp, 20.0, 'odometry')
    scan = seen[0]
    assert scan.header.frame_id == 'camera_depth_frame'
    assert (scan.range_min, scan.range_max) == pytest.approx((0.45, 10.0))
    assert (scan.scan_time, scan.time_increment) == pytest.approx((0.1, 0.0))
    assert len(scan.ranges) == 640 and not scan.intensities
    assert scan.angle_max - scan.angle_min == pytest.approx(math.radians(60), abs=3e-3)
    side = math.ceil(math.radians(30) / scan.angle_increment)  # as clients count beams
    assert 320 + side <= 639, 'a client that looks 30 degrees to a side reads past the end'
    assert scan.angle_min + 639 * scan.angle_increment == pytest.approx(scan.angle_max, abs=1e-5)
    assert scan.ranges[320] == pytest.approx(5.087, abs=0.01), 'the end of the corridor'
    # The left wall comes last: angles are counted to the left.
    assert scan.ranges[0] == pytest.approx((0.75 + 0.0135) / math.sin(0.525), abs=0.01)
    assert scan.ranges[-1] == pytest.approx((0.75 - 0.0135) / math.sin(0.525), abs=0.01)
    stamps = [message.header.stamp.to_nsec() for message in seen]
    assert {after - before for before, after in zip(stamps, stamps[1:])} == {10**8}
    assert set(stamps[1:]) <= {message.header.stamp.to_nsec() for message in odometry.messages}


def test_the_parameters_shape_the_scan(simulated_time):
    with simulator('_scan:=true', ROOM, UNPACED, '_scan_beams:=361', '_scan_fov:=6.283', '_scan_rate:=4',
                   '_scan_range_min:=0.1', '_scan_range_max:=2.2', '_scan_noise:=0.01', '_seed:=5'):
        first, second = Recorder('scan', LaserScan).wait_for_count(2)
    assert len(first.ranges) == 361
    assert first.angle_max - first.angle_min == pytest.approx(6.283)
    assert (second.header.stamp - first.header.stamp).to_sec() == first.scan_time == 0.25
    assert (first.range_min, first.range_max) == pytest.approx((0.1, 2.2))
    for beam, expected in [(180, 2.087), (0, 1.913), (90, 2.0135), (270, 1.9865)]:
        assert first.ranges[beam] == pytest.approx(expected, abs=0.05)
    assert math.inf in first.ranges, 'the corners of the room are farther'
    assert first.ranges != second.ranges, 'they have no noise'
