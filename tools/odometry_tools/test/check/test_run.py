"""What a run keeps of odometry and commands."""

import math

import pytest
from odometry_tools.check.bench import Pace
from odometry_tools.check.run import Command, Pose, Run
from odometry_tools.check.scenarios import EXERCISES


@pytest.mark.parametrize('yaws, turned, start', [
    ([3.1, 0.1, 0.3], 0.2, 1), ([3.1, -3.1], 2 * math.pi - 6.2, 0)])
def test_a_reset_of_the_heading_is_no_turn_and_begins_anew(yaws, turned, start):
    """While 180 degrees are passed as any other heading; right_resets_odometry looks at positions."""
    run = Run(EXERCISES['two_meters'].scenarios[0], Pace(), lambda run: False)
    for number, yaw in enumerate(yaws):
        run.take(Pose(0.05 * number, 0.0, 0.0, yaw, 0.0, 0.0))
    assert (run.odometry[-1].turned, run.start) == (pytest.approx(turned), start)


@pytest.mark.parametrize('linear, angular, moves', [
    (0.0, 0.0, False), (1e-4, 0.0, False), (-0.1, 0.0, True), (0.0, 0.1, True), (math.nan, 0.0, True)])
def test_nan_is_not_zero(linear, angular, moves):
    assert Command(0.0, linear, angular, (), 'cmd_vel').moves == moves
