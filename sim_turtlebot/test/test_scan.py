"""The laser scan: what the depth camera sees, against walls that are known, and what a client gets."""

import math
from fractions import Fraction

import numpy
import pytest
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import Simulation, settings_of
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from sensor_msgs.msg import LaserScan
from sim_turtlebot.kobuki import DEPTH_CAMERA as CAMERA
from sim_turtlebot.robot.scanner import Scanner

WORLDS = ROOT / 'sim_turtlebot/worlds'
CLOSE = 0.01  # m
FAR = math.inf
TOO_CLOSE = -math.inf
ROOM = f'_world:={ROOT}/sim_turtlebot/worlds/room.urdf'
CORRIDOR = f'_world:={ROOT}/sim_turtlebot/worlds/corridor.urdf'
SCANS = 20
UNPACED = '_real_time_factor:=0'  # and without a queue from which messages could drop


def scan_in(world, *starts, robot=0, **options):
    simulation = Simulation(*starts, world=world and str(WORLDS / world))
    return Scanner(simulation.robots[robot].body, settings_of(**options)).scan(0)


@pytest.mark.parametrize('start, expected', [
    ((0.0, 0.0, 0.0), 2.087), ((1.63, 0.0, 0.0), 0.457), ((1.64, 0.0, 0.0), TOO_CLOSE), ((-1.0, 0.0, 0.0), FAR),  # a wall
    ((0.0, 1.2, 0.0), 1.087), ((0.0, -1.3, math.pi), 0.737)])  # boxes
def test_walls_and_boxes_are_seen_where_they_are_and_what_is_out_of_range_is_infinite(start, expected):
    seen = scan_in('room.urdf', start, scan_beams=3, scan_fov=0.01, scan_range_max=3.0)
    assert seen == pytest.approx(expected, abs=CLOSE)


def test_robots_see_each_other():
    """Their plates, at the height of the camera; one behind the other is hidden."""
    starts = (0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (3.0, 0.0, 0.0)
    options = {'scan_beams': 3, 'scan_fov': 0.02}
    rear = -0.157  # m, of the plates
    for robot, expected in [(0, 2.0 + rear - CAMERA[0]), (1, 1.0 + rear - CAMERA[0]), (2, FAR)]:
        assert scan_in('', *starts, robot=robot, **options) == pytest.approx(expected, abs=CLOSE)


def test_to_look_changes_nothing():
    ends = []
    for look in False, True:
        simulation = Simulation((0.0, 0.0, 0.0), (0.0, 1.0, 0.0),
                                world=str(WORLDS / 'room.urdf'))
        scanner = Scanner(simulation.robot.body, settings_of(scan_noise=0.01))
        for _ in range(100):
            simulation.drive(0.3, 0.5, 0.05)
            if look:
                scanner.scan(0)
        ends.append(simulation.robot.ground_truth)
    assert ends[0] == ends[1]


def test_noise_is_as_wide_as_it_is_said_to_be():
    """Centred on the true range, and independent for each beam, scan, seed and robot."""
    true = scan_in('room.urdf', scan_beams=2000)
    noises = []
    for seed, index, number in [(0, 0, 0), (0, 0, 1), (-1, 0, 0), (0, 1, 0)]:
        simulation = Simulation(world=str(WORLDS / 'room.urdf'))
        scanner = Scanner(simulation.robot.body, settings_of(scan_beams=2000, scan_noise=0.02, seed=seed), index)
        noises.append(scanner.scan(number) - true)
        assert (scanner.scan(number) - true == noises[-1]).all(), 'repeated'
        assert noises[-1].mean() == pytest.approx(0.0, abs=0.002)
        assert noises[-1].std() == pytest.approx(0.02, rel=0.1)
    correlations = numpy.corrcoef(noises) - numpy.eye(len(noises))
    assert abs(correlations).max() < 0.1


def test_noise_takes_no_range_beyond_its_limits():
    seen = scan_in('room.urdf', scan_beams=1000, scan_fov=0.02, scan_range_min=2.05,
                   scan_range_max=2.12, scan_noise=0.05)
    finite = seen[numpy.isfinite(seen)]
    assert {FAR, TOO_CLOSE} < set(seen) and len(finite) > 100
    assert finite.min() >= 2.05 and finite.max() <= 2.12


@pytest.mark.parametrize('scan_rate, odom_rate', [
    (10, 20), (8, 20), (15, 22)])  # as floating point has it, 15/22 times 22 is a little less than 15
def test_a_scan_is_due_at_the_first_odometry_after_its_time(scan_rate, odom_rate):
    """Never late by more than one odometry period, whatever the rates."""
    scanner = Scanner(Simulation().robot.body, settings_of(scan_rate=scan_rate, odom_rate=odom_rate))
    due = [count for count in range(odom_rate + 1) if scanner.is_due(count)]
    assert due == [math.ceil(Fraction(number * odom_rate, scan_rate)) for number in range(scan_rate + 1)]


def test_a_scan_is_that_of_the_depth_camera(simulated_time):
    """640 beams in 60 degrees, ten times a second."""
    with simulator('_scan:=true', CORRIDOR, UNPACED):
        seen = Recorder('scan', LaserScan).wait_for_count(SCANS)
    scan = seen[0]
    assert scan.header.frame_id == 'camera_depth_frame'
    assert (scan.range_min, scan.range_max) == pytest.approx((0.45, 10.0))
    assert (scan.scan_time, scan.time_increment) == pytest.approx((0.1, 0.0))
    assert len(scan.ranges) == 640 and not scan.intensities
    assert scan.angle_max - scan.angle_min == pytest.approx(math.radians(60), abs=3e-3)
    side = math.ceil(math.radians(30) / scan.angle_increment)  # as clients count beams
    assert 320 + side <= 639, 'a client that looks 30 degrees to a side reads past the end'
    assert scan.ranges[320] == pytest.approx(5.087, abs=0.01), 'the end of the corridor'
    # The left wall comes last: angles are counted to the left.
    assert scan.ranges[0] == pytest.approx((0.75 + 0.0135) / math.sin(0.525), abs=0.01)
    assert scan.ranges[-1] == pytest.approx((0.75 - 0.0135) / math.sin(0.525), abs=0.01)
    stamps = [message.header.stamp.to_nsec() for message in seen]
    assert {after - before for before, after in zip(stamps, stamps[1:])} == {10**8}


def test_the_parameters_shape_the_scan(simulated_time):
    with simulator('_scan:=true', ROOM, UNPACED, '_scan_beams:=361', '_scan_fov:=6.283', '_scan_rate:=4',
                   '_scan_range_min:=0.1', '_scan_range_max:=2.2', '_scan_noise:=0.01', '_seed:=5'):
        first, second = Recorder('scan', LaserScan).wait_for_count(2)
    assert len(first.ranges) == 361
    assert first.angle_max - first.angle_min == pytest.approx(6.283)
    assert (second.header.stamp - first.header.stamp).to_sec() == first.scan_time == 0.25
    assert (first.range_min, first.range_max) == pytest.approx((0.1, 2.2))
    assert math.inf in first.ranges, 'the corners of the room are farther'
    assert first.ranges != second.ranges, 'they have no noise'
