"""What the depth camera sees, against walls and robots whose places are known."""

import math

import numpy
import pytest
from odometry_common.kobuki import DEPTH_CAMERA as CAMERA
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import Simulation, settings_of
from sim_turtlebot.robot.scanner import Scanner, is_scan_due

WORLDS = ROOT / 'sim_turtlebot' / 'worlds'
ALL_ROUND = 2 * math.pi
CLOSE = 0.01  # m
FAR = math.inf
TOO_CLOSE = -math.inf
# Faces of the room's walls (m), and of its boxes as the least and the greatest x and y.
WALL = 2.0
BOXES = [(1.0, 1.4, 1.0, 1.4), (-1.5, -0.9, 0.75, 1.05), (-0.95, -0.65, -1.45, -1.15)]


def scan_in(world, *starts, robot=0, **options):
    simulation = Simulation(*starts, world=world and str(WORLDS / world))
    return Scanner(simulation.robots[robot].body, settings_of(**options)).scan(0)


def range_in_box(x, y, angle, box):
    least, greatest = -math.inf, math.inf
    for place, step, low, high in ((x, math.cos(angle), *box[:2]), (y, math.sin(angle), *box[2:])):
        bounds = sorted([(low - place) / (step or 1e-12), (high - place) / (step or 1e-12)])
        least, greatest = max(least, bounds[0]), min(greatest, bounds[1])
    if greatest < max(least, 0.0):
        return math.inf
    return greatest if least < 0 else least


def range_in_room(x, y, angle):
    return min(range_in_box(x, y, angle, box) for box in [(-WALL, WALL, -WALL, WALL), *BOXES])


@pytest.mark.parametrize('x, y, yaw', [
    (0.0, 0.0, 0.0), (0.0, 0.0, 0.7), (1.0, -1.0, -2.0), (-1.0, 0.0, math.pi), (0.3, 1.2, 3.0)])
@pytest.mark.parametrize('beams, field_of_view', [(640, 1.012), (361, ALL_ROUND), (2, 0.01)])
def test_walls_and_boxes_are_seen_where_they_are(x, y, yaw, beams, field_of_view):
    seen = scan_in('room.urdf', (x, y, yaw), scan_beams=beams, scan_fov=field_of_view,
                   scan_range_min=0.01)
    sensor_x = x + CAMERA[0] * math.cos(yaw) - CAMERA[1] * math.sin(yaw)
    sensor_y = y + CAMERA[0] * math.sin(yaw) + CAMERA[1] * math.cos(yaw)
    angles = yaw - field_of_view / 2 + field_of_view / (beams - 1) * numpy.arange(beams)
    # Beside an edge a beam may pass it or meet it.
    known = numpy.array([[range_in_room(sensor_x, sensor_y, angle + beside)
                          for beside in (-1e-4, 0.0, 1e-4)] for angle in angles])
    nearer, farther = known.min(axis=1) - CLOSE, known.max(axis=1) + CLOSE
    assert ((nearer <= seen) & (seen <= farther)).all(), list(zip(angles, known, seen))


@pytest.mark.parametrize('x, expected', [(0.0, 2.087), (1.5, 0.587), (1.63, 0.457),
                                         (1.64, TOO_CLOSE), (1.8, TOO_CLOSE), (-1.0, FAR)])
def test_what_is_out_of_range_is_infinite(x, expected):
    seen = scan_in('room.urdf', (x, 0.0, 0.0), scan_beams=3, scan_fov=0.02, scan_range_max=3.0)
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
    for look in (False, True):
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
        settings = settings_of(scan_beams=2000, scan_noise=0.02, seed=seed)
        scanner = Scanner(simulation.robot.body, settings, index)
        noises.append(scanner.scan(number) - true)
        assert (scanner.scan(number) - true == noises[-1]).all(), 'repeated'
        assert noises[-1].mean() == pytest.approx(0.0, abs=0.002)
        assert noises[-1].std() == pytest.approx(0.02, rel=0.1)
    correlations = numpy.corrcoef(noises) - numpy.eye(len(noises))
    assert numpy.abs(correlations).max() < 0.1


def test_noise_takes_no_range_beyond_its_limits():
    seen = scan_in('room.urdf', scan_beams=1000, scan_fov=0.02, scan_range_min=2.05,
                   scan_range_max=2.12, scan_noise=0.05)
    finite = seen[numpy.isfinite(seen)]
    assert {FAR, TOO_CLOSE} < set(seen) and len(finite) > 100
    assert finite.min() >= 2.05 and finite.max() <= 2.12


@pytest.mark.parametrize('scan_rate, odom_rate, expected', [
    (10, 20, [0, 2, 4, 6, 8]), (20, 20, [0, 1, 2, 3, 4]), (8, 20, [0, 3, 5, 8, 10]),
    (30, 50, [0, 2, 4, 5, 7]), (0.1, 20, [0, 200, 400, 600, 800]), (1 / 3, 1, [0, 3, 6, 9, 12]),
    # As floating point has it, 15/22 times 22 is a little less than 15.
    (15, 22, [0, 2, 3, 5, 6, 8, 9, 11, 12, 14, 15, 17, 18, 20, 21, 22])])
def test_a_scan_is_due_at_the_first_odometry_after_its_time(scan_rate, odom_rate, expected):
    """Never late by more than one odometry period, whatever the rates."""
    due = [count for count in range(expected[-1] + 1) if is_scan_due(count, scan_rate, odom_rate)]
    assert due == expected
