"""What is commanded after any sequence of messages, with any parameter values."""

import math

import pytest
from geometry_msgs.msg import Quaternion
from heading_control.turn import Turn
from hypothesis import given, settings
from hypothesis import strategies as st
from odometry_common.geometry import wrap_to_pi, yaw_from_orientation
from odometry_tests.fuzzing import any_number, sequence_count
from straight_drive.drive import Drive

PERIOD = 0.1  # s between two commands of rotate.py

many = settings(max_examples=sequence_count())

finite = any_number.filter(math.isfinite)
positive = finite.filter(lambda value: value > 0)
moved_distances = st.one_of(any_number, st.floats(0, 10))
quaternions = st.builds(Quaternion, *[st.one_of(st.floats(-1, 1), any_number)] * 4)


@many
@given(st.one_of(st.just(2.0), positive), finite.filter(bool), st.booleans(),
       st.lists(moved_distances, max_size=50))
def test_the_mover_commands_its_speed_or_zero(distance, speed, relative, sequence):
    """Against a model: the drive starts at zero, or at the first distance that is a number."""
    drive = Drive(distance, speed, relative)
    numbers = list(filter(math.isfinite, sequence))
    start = numbers[0] if relative and numbers else 0.0
    for moved in sequence:
        if math.isfinite(moved):
            assert drive.speed_at(moved) == (speed if moved - start < distance else 0.0)
        else:
            with pytest.raises(ValueError, match='is not finite'):
                drive.speed_at(moved)


@many
@given(quaternions, finite, positive, positive)
def test_whatever_the_heading_and_the_target_the_turn_is_within_the_clamp(
        quaternion, target_deg, kp, limit):
    """And towards the target by the shorter way; a quaternion that is no rotation is refused."""
    parts = quaternion.x, quaternion.y, quaternion.z, quaternion.w
    length = math.hypot(*parts)
    if length == 0 or not math.isfinite(length):
        with pytest.raises(ValueError, match='is no rotation'):
            yaw_from_orientation(quaternion)
        return
    yaw = yaw_from_orientation(quaternion)
    assert abs(yaw) <= math.pi
    turn = Turn(target_deg, kp, limit)
    error = turn.error_at(yaw)
    assert -math.pi < error <= math.pi
    command = turn.speed_for(error)
    assert abs(command) <= limit
    assert command == 0 or (command > 0) == (error > 0)


@many
@given(st.floats(-math.pi, math.pi), st.floats(1e-3, 1 / PERIOD), st.floats(1e-3, math.pi),
       st.lists(st.tuples(st.floats(-1e6, 1e6), st.integers(1, 20)), max_size=10))
def test_a_robot_that_obeys_never_turns_away_from_its_target(yaw, kp, limit, targets):
    """Whenever the target changes; with a gain that a control rate of 10 Hz can follow."""
    for target_deg, commands in targets:
        turn = Turn(target_deg, kp, limit)
        error = turn.error_at(yaw)
        for _ in range(commands):
            yaw = wrap_to_pi(yaw + PERIOD * turn.speed_for(error))
            left = turn.error_at(yaw)
            assert abs(left) <= abs(error) + 1e-9
            error = left
