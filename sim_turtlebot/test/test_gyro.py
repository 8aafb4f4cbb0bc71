"""The gyro, from which a Kobuki takes its heading."""

import math

import pytest
from odometry_common.geometry import about_z
from odometry_tests.arcs import PERIOD, Robot, drive, motion

ERRORS = {'gyro_noise': 0.02, 'gyro_drift': 0.01, 'seed': 3}


def test_without_errors_it_is_the_rotation_since_the_reset():
    """Past half a turn too."""
    robot = Robot()
    robot.start(motion(yaw=3.0))
    assert (robot.gyro.heading, robot.gyro.rate) == (0.0, 0.0)
    for number in range(1, 101):
        robot.move(motion(yaw=3.0 + number * 0.1))
        assert robot.gyro.rate == pytest.approx(0.1 / PERIOD)
        assert math.remainder(robot.gyro.heading - number * 0.1, 2 * math.pi) == pytest.approx(0)


@pytest.mark.parametrize('drift', [0.01, -0.002])
@pytest.mark.parametrize('source', ['world', 'encoder'])
def test_drift_is_in_proportion_to_time_also_at_rest(source, drift):
    """The heading of a robot that stands turns away; its place does not."""
    robot = Robot(odometry_source=source, gyro_drift=drift)
    last = drive(robot, 0.0, duration=20.0)[-1]
    assert robot.gyro.heading == pytest.approx(20.0 * drift)
    assert robot.gyro.rate == pytest.approx(drift)
    assert last.position == (0.0, 0.0, 0.0)


def test_the_heading_of_the_encoders_is_that_of_the_gyro():
    """One gyro, one noise: to the bit, in each message, rate and reset included."""
    robot = Robot(odometry_source='encoder', wheel_noise=0.01, **ERRORS)
    for _ in range(2):  # it begins with a reset
        for row in drive(robot, 0.3, 0.5):
            assert row.orientation[:2] == (0.0, 0.0)
        assert row.orientation == about_z(robot.gyro.heading)
        assert row.angular == (0.0, 0.0, robot.gyro.rate)
    robot.reset_odometry()
    assert robot.gyro.heading == 0.0


def test_the_odometry_of_the_world_does_not_mind_its_gyro():
    robot = Robot(**ERRORS)
    assert drive(robot, 0.3, 0.5) == drive(Robot(), 0.3, 0.5)
    assert robot.gyro.heading != 0.0


@pytest.mark.parametrize('turn_speed', [0.5, -0.5])
def test_a_wrong_scale_counts_in_proportion_and_the_correction_ends_it(turn_speed):
    """To either side."""
    for correction, factor in [(1.0, 1.02), (1 / 1.02, 1.0)]:
        robot = Robot(gyro_scale_error=0.02, gyro_scale_correction=correction)
        drive(robot, 0.0, turn_speed, duration=4.0)
        assert robot.gyro.heading == pytest.approx(4 * turn_speed * factor)
        assert robot.gyro.rate == pytest.approx(turn_speed * factor)
