"""Which way and how fast to turn."""

import math

from hypothesis import given
from hypothesis import strategies as st
from odometry_common.geometry import wrap_to_pi
from odometry_common.velocity import clamp


@given(st.floats(-math.pi, math.pi), st.floats(-1e6, 1e6), st.floats(1e-3, 1e3),
       st.floats(1e-3, 10))
def test_a_command_never_passes_the_clamp_and_points_the_shorter_way(yaw, target, kp, limit):
    """The sign of the command is the sign of the shortest error."""
    error = wrap_to_pi(target - yaw)
    command = clamp(kp * error, limit)
    assert abs(command) <= limit
    assert command * error >= 0
