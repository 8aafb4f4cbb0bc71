"""Where a robot believes it is after motions that are made up here, and what its sensors get wrong."""

import math
import statistics

import pytest
from arcs import TICK, Robot, drive, motion, on_arc, wheel_angles
from hypothesis import given
from hypothesis import strategies as st
from sim_turtlebot.geometry import PlanarPose, about_z, yaw_of
from sim_turtlebot.kobuki import WHEEL_SEPARATION
from sim_turtlebot.robot.odometry import STILL, Motion

RUNS = 400  # seeds, for a standard deviation within about a tenth

places = st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4), st.floats(-3.1, 3.1))


def encoders(**parameters):
    return Robot(odometry_source='encoder', **parameters)


@given(places, places)
def test_world_odometry_is_the_pose_seen_from_the_start(start, place):
    """At the start it is zero, whichever way the robot was put down."""
    robot = Robot()
    first = robot.start(motion(*start))
    assert first.position == pytest.approx(STILL, abs=1e-12)
    assert yaw_of(first.orientation) == pytest.approx(0, abs=1e-12)
    now = robot.move(motion(*place))
    x, y, yaw = PlanarPose(*start).then(PlanarPose(*now.position[:2], yaw_of(now.orientation)))
    assert (x, y) == pytest.approx(place[:2], abs=1e-9)
    assert math.remainder(yaw - place[2], math.tau) == pytest.approx(0, abs=1e-9)
    assert (now.linear, now.angular) == (STILL, STILL), 'it was put there'
    assert now.orientation[3] >= 0


TILTED = Motion((1.0, 2.0, 0.03), (0.1, 0.0, 0.0, math.sqrt(0.99)), (0.2, 0.01, 0), (0, 0, 1))


def test_world_odometry_is_a_full_pose_and_over_a_long_time_the_twist_of_the_moment():
    """The mean of a second says little of the velocity, and a turn may be more than half."""
    robot = Robot(odom_rate=1.0)
    robot.start(motion(1.0, 2.0, 0.5))
    now = robot.move(TILTED)
    assert now.position[2] == pytest.approx(0.03)
    assert math.hypot(*now.orientation[:2]) == pytest.approx(0.1)
    assert (*now.linear, *now.angular) == pytest.approx((*TILTED.linear, *TILTED.angular))


@pytest.mark.parametrize('speed, turn_speed', [(0.5, 0.0), (-0.3, 0.4), (0.0, 0.6 * math.pi), (0.2, -3.0)])
def test_on_an_arc_the_encoders_keep_to_the_closed_form(speed, turn_speed):
    """Yaw to a tick of each wheel; the position to what such a yaw and the chords of the arc allow."""
    x, y, yaw = on_arc(speed, turn_speed, 10.0)
    last = drive(encoders(gyro=False), speed, turn_speed)[-1]
    assert abs(math.remainder(yaw_of(last.orientation) - yaw, math.tau)) <= 2 * TICK / WHEEL_SEPARATION
    assert math.dist(last.position[:2], (x, y)) <= 0.005


@pytest.mark.parametrize('gyro', [False, True])
def test_a_robot_that_is_carried_is_where_it_was_by_its_encoders(gyro):
    """Its gyro, if it has one, notices that it was turned; nothing has a speed."""
    robot = encoders(gyro=gyro)
    robot.start(motion(1.0, 2.0, 0.5))
    before = robot.move(motion(1.5, 2.0, 0.5), wheel_angles(0.5, 0.0))
    robot.set_pose((-3.0, 7.0, 0.0), about_z(2.5))
    carried = robot.odometry
    assert carried.position == before.position
    assert yaw_of(carried.orientation) == pytest.approx(2.0 if gyro else 0.0)
    assert (carried.linear, carried.angular) == (STILL, STILL)
    assert robot.gyro.rate == 0.0
    after = robot.move(motion(-3.0, 7.0, 2.5), wheel_angles(0.5, 0.0))
    assert after == carried._replace(linear=after.linear, angular=after.angular)
    assert (after.linear, after.angular) == (STILL, STILL)


@pytest.mark.parametrize('slip', [0.01, 0.1, 0.5])
def test_slip_shows_as_travel_that_moved_nothing(slip):
    whole = drive(encoders(wheel_slip=slip), 0.5)[-1].position[0]
    assert whole * (1 - slip) == pytest.approx(5.0, abs=TICK)


@pytest.mark.parametrize('noise, speed, duration, grown', [
    ('wheel_noise', 0.5, 1.0, 0.25), ('wheel_noise', 0.5, 4.0, 1.0), ('wheel_noise', 0.125, 4.0, 0.25),
    ('gyro_noise', 0.0, 0.5, 0.5), ('gyro_noise', 0.0, 2.0, 2.0)])
def test_noise_grows_with_the_root_of_the_travel_or_of_time(noise, speed, duration, grown):
    """Each wheel has its own; the middle between two has half the variance."""
    ends = [drive(encoders(seed=seed, **{noise: 0.02}), speed, 0.0, duration)[-1] for seed in range(RUNS)]
    values = [end.position[0] if speed else yaw_of(end.orientation) for end in ends]
    expected = 0.02 * math.sqrt(grown)
    assert statistics.stdev(values) == pytest.approx(expected, rel=0.12)
    assert statistics.mean(values) == pytest.approx(speed * duration, abs=4 * expected / RUNS**0.5)


@pytest.mark.parametrize('parameters, turn_speed, rate', [
    ({'gyro_drift': 0.01}, 0.0, 0.01), ({'gyro_drift': -0.002, 'odometry_source': 'encoder'}, 0.0, -0.002),
    ({'gyro_scale_error': 0.02}, -0.5, -0.51), ({'gyro_scale_error': 0.02, 'gyro_scale_correction': 1 / 1.02}, 0.5, 0.5)])
def test_the_gyro_drifts_also_at_rest_and_has_a_wrong_scale_that_the_correction_ends(parameters, turn_speed, rate):
    robot = Robot(**parameters)
    drive(robot, 0.0, turn_speed, duration=4.0)
    assert robot.gyro.heading == pytest.approx(4.0 * rate)
    assert robot.gyro.rate == pytest.approx(rate)


@pytest.mark.parametrize('gyro, yaw, turn', [(False, 0.2, 0.02), (True, 0.05, 0.005)])
def test_the_covariance_is_that_of_a_kobuki(gyro, yaw, turn):
    """That of a filter's input must not be zero."""
    robot = encoders(gyro=gyro)
    assert robot.estimator.covariance == (0.1, 0.1, 1e10, 1e10, 1e10, yaw)
    assert robot.estimator.twist_covariance == (0.001, 0.001, 1e10, 1e10, 1e10, turn)
