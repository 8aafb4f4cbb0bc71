"""How fast rotate.py turns at which heading."""

import math

import pytest
from heading_control.turn import Turn


@pytest.mark.parametrize('target, yaw, error', [
    (90, 0, 90), (90, 90, 0), (180, 0, 180), (-180, 0, 180), (270, 0, -90), (720, 10, -10),
    (-170, 170, 20)])
def test_the_error_is_the_shorter_way_round(target, yaw, error):
    """In radians; half a circle is to the left."""
    assert Turn(target, 0.5, 3.14).error_at(math.radians(yaw)) == pytest.approx(math.radians(error))


@pytest.mark.parametrize('error, speed', [(1.0, 0.5), (-1.0, -0.5), (3.0, 1.0), (-3.0, -1.0), (0.0, 0.0)])
def test_the_speed_is_gain_times_error_within_its_limit(error, speed):
    """To both sides."""
    assert Turn(90.0, 0.5, 1.0).speed_for(error) == speed
