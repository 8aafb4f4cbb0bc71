"""What a run keeps of odometry and commands."""

import math

import pytest
from odometry_tools.check.bench import Pace
from odometry_tools.check.run import Command, Pose, Run
from odometry_tools.check.scenarios import EXERCISES


def run_of(*places):
    """Return a Run whose odometry has been at these: x, y (m) and yaw (rad)."""
    run = Run(EXERCISES['two_meters'].scenarios[0], Pace(), lambda run: False)
    for number, place in enumerate(places):
        run.take(Pose(0.05 * number, *place, 0.0, 0.0))
    return run


@pytest.mark.parametrize('places, way, turned, start', [
    ([(3.0, 1.0, 0.0), (3.1, 1.0, 0.0), (0.0, 0.0, 0.0), (0.1, 0.0, 0.0)], 0.2, 0.0, 2),
    ([(0.0, 0.0, 3.1), (0.0, 0.0, 0.1), (0.0, 0.0, 0.3)], 0.0, 0.2, 1),
    ([(0.0, 0.0, 3.1), (0.0, 0.0, -3.1)], 0.0, 2 * math.pi - 6.2, 0)])
def test_a_reset_of_odometry_is_no_way_and_begins_anew(places, way, turned, start):
    """While 180 degrees are passed as any other heading."""
    run = run_of(*places)
    end = run.odometry[-1]
    assert (end.way, end.turned, run.start) == (pytest.approx(way), pytest.approx(turned), start)


@pytest.mark.parametrize('linear, angular, moves', [
    (0.0, 0.0, False), (1e-4, 0.0, False), (-0.1, 0.0, True), (0.0, 0.1, True), (math.nan, 0.0, True)])
def test_nan_is_not_zero(linear, angular, moves):
    assert Command(0.0, linear, angular, (), 'cmd_vel').moves == moves
