"""What a run keeps of odometry."""

import math

import pytest
from kinematic_robot import PLAIN
from odometry_tools.check.check_session import Pace
from odometry_tools.check.run import Pose, Run


@pytest.mark.parametrize('yaws, turned, start', [
    ([3.1, 0.1, 0.3], 0.2, 1), ([3.1, -3.1], math.tau - 6.2, 0)])
def test_a_reset_of_the_heading_is_no_turn_and_begins_anew(yaws, turned, start):
    """While 180 degrees are passed as any other heading; right_resets_odometry looks at positions."""
    run = Run(PLAIN, Pace(), lambda run: False)
    for number, yaw in enumerate(yaws):
        run.take(Pose(0.05 * number, 0.0, 0.0, yaw, 0.0, 0.0))
    assert (run.odometry[-1].turned, run.start) == (pytest.approx(turned), start)
