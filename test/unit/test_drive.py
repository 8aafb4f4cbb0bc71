"""How fast test_movement drives after which distance."""

import math

import pytest
from straight_drive.drive import Drive


@pytest.mark.parametrize('moved, speed', [
    (0.0, 0.1), (1.0, 0.1), (math.nextafter(2, 0), 0.1), (2.0, 0.0), (2.5, 0.0), (1e308, 0.0)])
def test_it_drives_until_two_metres_and_stands_from_there_on(moved, speed):
    """Exactly two metres are far enough."""
    assert Drive(2.0, 0.1).speed_at(moved) == speed


def test_a_negative_speed_drives_backwards_as_far():
    """The moved distance has no sign."""
    drive = Drive(2.0, -0.1)
    assert [drive.speed_at(moved) for moved in (0.0, 1.9, 2.0)] == [-0.1, -0.1, 0.0]


def test_each_distance_decides_alone():
    """So a reset of the distance sends the robot off again, as the README says."""
    drive = Drive(2.0, 0.1)
    assert [drive.speed_at(moved) for moved in (2.1, 0.0, 2.1)] == [0.0, 0.1, 0.0]


def test_relative_counts_from_the_first_distance_seen():
    """A second run after two metres goes to four."""
    drive = Drive(2.0, 0.1, relative=True)
    sequence = [2.0, 3.9, 4.0, 3.0, 0.0]
    assert [drive.speed_at(moved) for moved in sequence] == [0.1, 0.1, 0.0, 0.1, 0.1]


@pytest.mark.parametrize('relative', [False, True])
@pytest.mark.parametrize('moved', [math.nan, math.inf, -math.inf])
def test_a_distance_that_is_not_finite_is_refused(moved, relative):
    """And is no start for a relative drive."""
    drive = Drive(2.0, 0.1, relative)
    with pytest.raises(ValueError, match='is not finite'):
        drive.speed_at(moved)
    assert drive.speed_at(1.0) == 0.1
    assert drive.speed_at(2.5) == (0.1 if relative else 0.0)
