"""What a Kobuki's odometry gets wrong: slipping wheels, noise; and its gyro, which mends some of it."""

import math
import statistics

import pytest
from odometry_common.geometry import about_z, yaw_of
from odometry_common.kobuki import WHEEL_SEPARATION
from odometry_tests.arcs import PERIOD, TICK, Robot, drive, motion, wheel_angles
from odometry_tests.simulation import Simulation

RUNS = 400  # seeds, for a standard deviation within about a tenth
ERRORS = {'wheel_slip': 0.01, 'wheel_noise': 0.01, 'gyro_noise': 0.01}
GYRO_ERRORS = {'gyro_noise': 0.02, 'gyro_drift': 0.01, 'seed': 3}


def encoders(**errors):
    return Robot(odometry_source='encoder', **errors)


def distance(track):
    """Return the distance (m) that odometry has counted, forwards positive."""
    return sum(row.linear[0] for row in track) * PERIOD


@pytest.mark.parametrize('robot', [Robot(), encoders(wheel_slip=0.01, wheel_noise=0.01)])
def test_at_rest_the_odometry_does_not_change(robot):
    """Not even with noisy wheels: they do not turn."""
    assert len(set(drive(robot, 0.0))) == 1


@pytest.mark.parametrize('slip', [0.01, 0.1, 0.5])
def test_slip_shows_as_travel_that_moved_nothing(slip):
    """Of the travel that the encoders count, a share of `slip`."""
    whole = drive(encoders(wheel_slip=slip), 0.5)[-1].position[0]
    assert whole * (1 - slip) == pytest.approx(5.0, abs=TICK)


@pytest.mark.parametrize('gyro', [False, True])
def test_without_noise_the_seed_makes_no_difference(gyro):
    """Noise that is off draws no random numbers."""
    tracks = {tuple(drive(encoders(gyro=gyro, wheel_slip=0.01, seed=seed), 0.3, 0.5)) for seed in range(5)}
    assert len(tracks) == 1


def test_noise_is_the_same_with_the_same_seed_and_another_with_another():
    def run(seed):
        return tuple(drive(encoders(seed=seed, **ERRORS), 0.3, 0.5))

    assert run(7) == run(7)
    assert len({run(seed) for seed in range(5)}) == 5


@pytest.mark.parametrize('speed, duration', [(0.5, 1.0), (0.5, 4.0), (0.125, 4.0)])
def test_wheel_noise_grows_with_the_root_of_the_travel(speed, duration):
    """Each wheel has its own; the middle between two has half the variance."""
    travels = [distance(drive(encoders(wheel_noise=0.02, seed=seed), speed, 0.0, duration))
            for seed in range(RUNS)]
    expected = 0.02 * math.sqrt(speed * duration / 2)
    assert statistics.stdev(travels) == pytest.approx(expected, rel=0.12)
    assert statistics.mean(travels) == pytest.approx(speed * duration, abs=4 * expected / RUNS**0.5)


@pytest.mark.parametrize('duration', [0.5, 2.0])
def test_gyro_noise_grows_with_the_root_of_time(duration):
    """Also while the robot stands, as a gyro's does."""
    yaws = [yaw_of(drive(encoders(gyro_noise=0.02, seed=seed), 0.0, 0.0, duration)[-1]
                   .orientation) for seed in range(RUNS)]
    assert statistics.stdev(yaws) == pytest.approx(0.02 * math.sqrt(duration), rel=0.12)


@pytest.mark.parametrize('gyro, believed', [(False, 1.0), (True, 0.25)])
def test_with_the_gyro_the_yaw_is_that_of_the_body(gyro, believed):
    """Wheels that turn against each other on ice turn the robot less than they say."""
    now = encoders(gyro=gyro).move(motion(yaw=0.25), wheel_angles(0.0, 1.0))
    assert yaw_of(now.orientation) == pytest.approx(believed, abs=2 * TICK / WHEEL_SEPARATION)
    assert now.angular[2] == pytest.approx(believed / PERIOD, rel=1e-3)


@pytest.mark.parametrize('speed, turn_speed, true_yaw', [
    (0.3, 0.0, 4 * 0.3 * 0.02 / 2.01 / WHEEL_SEPARATION), (0.0, 0.5, 4 * 0.5 / 1.02)])
def test_what_the_driver_believes_bends_the_path_and_shows_in_no_wheel(speed, turn_speed, true_yaw):
    """It commands by the same wrong numbers as it counts; E_d is 1.01 and E_b 1.02."""
    simulation = Simulation(odometry_source='encoder', gyro=False, wheel_diameter_ratio=1.01,
                            wheel_separation_ratio=1.02)
    simulation.drive(speed, turn_speed, 4.0)
    record = simulation.drive(0.0, 0.0, 1.0)
    assert yaw_of(record.odometry[-1].orientation) == pytest.approx(4 * turn_speed, abs=0.003)
    assert yaw_of(record.ground_truth[-1].orientation) == pytest.approx(true_yaw, abs=0.004)


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
    robot = Robot(odometry_source='encoder', wheel_noise=0.01, **GYRO_ERRORS)
    for _ in range(2):  # it begins with a reset
        for row in drive(robot, 0.3, 0.5):
            assert row.orientation[:2] == (0.0, 0.0)
        assert row.orientation == about_z(robot.gyro.heading)
        assert row.angular == (0.0, 0.0, robot.gyro.rate)
    robot.reset_odometry()
    assert robot.gyro.heading == 0.0


def test_the_odometry_of_the_world_does_not_mind_its_gyro():
    robot = Robot(**GYRO_ERRORS)
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
