"""The gyro, from which a Kobuki takes its heading."""

import math

import pytest
from odometry_common.geometry import about_z, yaw_of
from odometry_tests.arcs import PERIOD, drive, motion
from sim_turtlebot.gyro import Gyro
from sim_turtlebot.odometry import EncoderOdometry, WorldOdometry

SOURCES = [lambda gyro_drift: WorldOdometry(Gyro(drift=gyro_drift)), EncoderOdometry]
ERRORS = {'gyro_noise': 0.02, 'gyro_drift': 0.01, 'seed': 3}


def test_without_errors_it_is_the_rotation_since_the_reset():
    """Past half a turn too."""
    gyro = Gyro()
    gyro.reset(about_z(3.0))
    assert (gyro.heading, gyro.rate) == (0.0, 0.0)
    for number in range(1, 101):
        gyro.update(about_z(3.0 + number * 0.1), PERIOD)
        assert gyro.rate == pytest.approx(0.1 / PERIOD)
        assert math.remainder(gyro.heading - number * 0.1, 2 * math.pi) == pytest.approx(0)


@pytest.mark.parametrize('drift', [0.01, -0.002])
@pytest.mark.parametrize('new', SOURCES)
def test_drift_is_in_proportion_to_time_also_at_rest(new, drift):
    """The heading of a robot that stands turns away; its place does not."""
    odometry = new(gyro_drift=drift)
    last = drive(odometry, 0.0, duration=20.0)[-1]
    assert odometry.gyro.heading == pytest.approx(20.0 * drift)
    assert odometry.gyro.rate == pytest.approx(drift)
    assert last.position == (0.0, 0.0, 0.0)


def test_the_heading_of_the_encoders_is_that_of_the_gyro():
    """One gyro, one noise: to the bit, in each message, rate and reset included."""
    odometry = EncoderOdometry(wheel_noise=0.01, **ERRORS)
    for _ in range(2):  # it begins with a reset
        for row in drive(odometry, 0.3, 0.5):
            assert row.orientation[:2] == (0.0, 0.0)
        assert row.orientation == about_z(odometry.gyro.heading)
        assert row.angular == (0.0, 0.0, odometry.gyro.rate)
    odometry.reset(motion(yaw=1.0))
    assert odometry.gyro.heading == 0.0


def test_the_odometry_of_the_world_does_not_mind_its_gyro():
    """The true pose stays the true pose."""
    gyro = Gyro(noise=0.02, drift=0.01)
    assert drive(WorldOdometry(gyro), 0.3, 0.5) == drive(WorldOdometry(), 0.3, 0.5)
    assert gyro.heading != 0.0


def test_without_use_of_the_gyro_the_wheels_keep_their_yaw():
    """And the gyro keeps its own."""
    odometry = EncoderOdometry(gyro=False, gyro_drift=0.01)
    assert yaw_of(drive(odometry, 0.5)[-1].orientation) == 0.0
    assert odometry.gyro.heading == pytest.approx(0.1)


def test_a_robot_that_is_carried_is_seen_to_turn_in_no_time():
    """Without noise, and without a rate."""
    gyro = Gyro(noise=0.1, drift=0.1)
    gyro.reset(about_z(0.2))
    assert gyro.carry(about_z(1.7)) == pytest.approx(1.5)
    assert gyro.heading == pytest.approx(1.5)
    assert gyro.rate == 0.0
