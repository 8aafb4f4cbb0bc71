"""How fast rotate.py turns at any heading, with any parameter values."""

import math

import pytest
from geometry_msgs.msg import Quaternion
from heading_control.turn import Turn
from hypothesis import example, given
from hypothesis import strategies as st
from odometry_common.orientation import yaw_from_orientation
from odometry_tests.fuzzing import any_number

finite = any_number.filter(math.isfinite)
positive = finite.filter(lambda value: value > 0)
quaternions = st.builds(Quaternion, *[st.floats(-1, 1) | any_number] * 4)


@given(quaternions, finite, positive, positive)
@example(Quaternion(w=1.0), -180.0, 0.5, 3.0)  # half a circle is to the left
@example(Quaternion(w=1.0), 60.0, 0.5, 3.0)
@example(Quaternion(w=1.0), 270.0, 0.5, 0.1)
def test_the_turn_is_the_gain_times_the_shorter_way_within_the_clamp(quaternion, target, kp, limit):
    """For any target (degrees); a quaternion that is no rotation is refused."""
    length = math.hypot(quaternion.x, quaternion.y, quaternion.z, quaternion.w)
    if length == 0 or not math.isfinite(length):
        with pytest.raises(ValueError, match='is no rotation'):
            yaw_from_orientation(quaternion)
        return
    yaw = yaw_from_orientation(quaternion)
    assert abs(yaw) <= math.pi
    turn = Turn(target, kp, limit)
    error = turn.error_at(yaw)
    assert -math.pi < error <= math.pi
    if abs(target) < 1e6:  # beyond, the target itself is less exact than the way to it
        off = math.remainder(yaw + error - math.radians(target), math.tau)
        assert off == pytest.approx(0.0, abs=1e-9)
    assert turn.speed_for(error) == max(-limit, min(limit, kp * error))
