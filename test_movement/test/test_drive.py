"""How fast test_movement drives after which distance."""

import pytest
from straight_drive.drive import Drive


@pytest.mark.parametrize('moved, speed', [
    (0.0, 0.1), (1.0, 0.1), (2.0 - 2**-52, 0.1), (2.0, 0.0), (2.5, 0.0), (1e308, 0.0)])
def test_it_drives_until_two_metres_and_stands_from_there_on(moved, speed):
    """Exactly two metres are far enough."""
    assert Drive(2.0, 0.1).speed_at(moved) == speed


def test_only_the_latest_distance_decides():
    """After a reset of the distance the robot drives on, as the README says."""
    drive = Drive(2.0, 0.1)
    assert [drive.speed_at(moved) for moved in (2.1, 0.0, 2.1)] == [0.0, 0.1, 0.0]


def test_relative_counts_from_the_first_distance_seen():
    """A second run after two metres goes to four."""
    drive = Drive(2.0, 0.1, relative=True)
    sequence = [2.0, 3.9, 4.0, 3.0, 0.0]
    assert [drive.speed_at(moved) for moved in sequence] == [0.1, 0.1, 0.0, 0.1, 0.1]
