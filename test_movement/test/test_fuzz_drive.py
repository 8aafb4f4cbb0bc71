"""How fast test_movement drives after any sequence of distances, with any parameter values."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from odometry_tests.fuzzing import any_number
from straight_drive.drive import Drive

finite = any_number.filter(math.isfinite)
goals = st.just(2.0) | finite.filter(lambda value: value > 0)


@given(goals, finite.filter(bool), st.booleans(), st.lists(st.floats(0, 10) | any_number, max_size=50))
@example(2.0, 0.1, False, [2.0 - 2**-52, 2.0])  # exactly two metres are far enough
def test_the_latest_distance_decides(goal, speed, relative, sequence):
    """Against a model: the drive starts at zero, or at the first distance that is a number."""
    drive = Drive(goal, speed, relative) if relative else Drive(goal, speed)
    start = next(filter(math.isfinite, sequence), 0.0) if relative else 0.0
    for moved in sequence:
        if math.isfinite(moved):
            assert drive.speed_at(moved) == (speed if moved - start < goal else 0.0)
        else:
            with pytest.raises(ValueError, match='is not finite'):
                drive.speed_at(moved)
