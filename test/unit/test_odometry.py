"""Where a robot believes to be after motions that are made up here."""

import math
import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sim_turtlebot.odometry import TICKS_PER_TURN, EncoderOdometry, Motion, WorldOdometry
from sim_turtlebot.physics import WHEEL_RADIUS, WHEEL_SEPARATION
from sim_turtlebot.rotations import about_z, yaw_of

PERIOD = 0.05  # s between two odometries at 20 Hz
TICK = 2 * math.pi * WHEEL_RADIUS / TICKS_PER_TURN  # m
RUNS = 400  # seeds, for a standard deviation within about a tenth
STILL = (0.0, 0.0, 0.0)
ERRORS = {'wheel_slip': 0.01, 'wheel_noise': 0.01, 'gyro_noise': 0.01}

places = st.tuples(st.floats(-100, 100), st.floats(-100, 100), st.floats(-3.1, 3.1))
speeds = st.floats(-0.7, 0.7)
turn_speeds = st.floats(-math.pi, math.pi)


def motion(x=0.0, y=0.0, yaw=0.0, linear=STILL, angular=STILL):
    """Return a Motion on the floor at x, y (m), yaw (rad)."""
    return Motion((x, y, 0.0), about_z(yaw), linear, angular)


def wheel_angles(travel, turn):
    """Return the angles (rad) to which wheels that roll true have turned."""
    difference = turn * WHEEL_SEPARATION / 2
    return (travel - difference) / WHEEL_RADIUS, (travel + difference) / WHEEL_RADIUS


def on_arc(speed, turn_speed, time):
    """Return the true x, y (m), yaw (rad) at a time (s) after a start at zero."""
    yaw = turn_speed * time
    if abs(turn_speed) < 1e-9:
        return speed * time, 0.0, yaw
    radius = speed / turn_speed
    return radius * math.sin(yaw), radius * (1 - math.cos(yaw)), yaw


def at_zero():
    """Return the angles of wheels that have not turned."""
    return 0.0, 0.0


def drive(odometry, speed, turn_speed=0.0, duration=10.0):
    """Drive an arc; return the odometry after each period."""
    odometry.reset(motion(), (0.0, 0.0))
    times = [number * PERIOD for number in range(1, round(duration / PERIOD) + 1)]
    return [odometry.update(motion(*on_arc(speed, turn_speed, time)),
                            lambda time=time: wheel_angles(speed * time, turn_speed * time), PERIOD)
            for time in times]


def distance(track):
    """Return the distance (m) that odometry has counted, forwards positive."""
    return sum(row.linear[0] for row in track) * PERIOD


@given(places, places)
def test_world_odometry_is_the_pose_seen_from_the_start(start, place):
    """At the start it is zero, whichever way the robot was put down."""
    odometry = WorldOdometry()
    first = odometry.reset(motion(*start))
    assert first.position == pytest.approx(STILL, abs=1e-12)
    assert yaw_of(first.orientation) == pytest.approx(0, abs=1e-12)
    now = odometry.update(motion(*place), at_zero, PERIOD)
    x, y = place[0] - start[0], place[1] - start[1]
    cos, sin = math.cos(start[2]), math.sin(start[2])
    assert now.position == pytest.approx((x * cos + y * sin, y * cos - x * sin, 0), abs=1e-9)
    turn = math.remainder(yaw_of(now.orientation) - (place[2] - start[2]), 2 * math.pi)
    assert turn == pytest.approx(0, abs=1e-9)


def test_world_odometry_keeps_height_tilt_and_velocity():
    """The tutorial's /odom is a full pose, and its twist is in the frame of the base."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, 0.5))
    tilted = Motion((1.0, 2.0, 0.03), (0.1, 0.0, 0.0, math.sqrt(0.99)), (0.2, 0.01, 0), (0, 0, 1))
    now = odometry.update(tilted, at_zero, PERIOD)
    assert now.position[2] == pytest.approx(0.03)
    assert math.hypot(*now.orientation[:2]) == pytest.approx(0.1)
    assert (now.linear, now.angular) == (tilted.linear, tilted.angular)


@given(speeds)
def test_straight_on_the_encoders_are_right_to_a_tick(speed):
    """However long the way: what is not yet a tick is not lost."""
    last = drive(EncoderOdometry(), speed)[-1]
    assert abs(last.position[0] - speed * 10) <= TICK
    assert last.position[1:] == (0.0, 0.0)
    assert last.orientation == (0.0, 0.0, 0.0, 1.0)


@given(speeds, turn_speeds)
def test_on_an_arc_the_encoders_keep_to_the_closed_form(speed, turn_speed):
    """Yaw to a tick of each wheel; the way to what that yaw and the periods' chords allow."""
    x, y, yaw = on_arc(speed, turn_speed, 10.0)
    last = drive(EncoderOdometry(), speed, turn_speed)[-1]
    yaw_error = 2 * TICK / WHEEL_SEPARATION
    assert abs(math.remainder(yaw_of(last.orientation) - yaw, 2 * math.pi)) <= yaw_error
    chord = (turn_speed * PERIOD)**2 / 24  # share by which an arc is longer than its chord
    way = abs(speed) * 10
    bound = way * (yaw_error + chord) + 2 * TICK
    assert math.dist(last.position[:2], (x, y)) <= bound


def test_a_spin_moves_no_encoder_odometry():
    """The wheels turn against each other, and three turns later x and y are still zero."""
    last = drive(EncoderOdometry(), 0.0, 6 * math.pi / 10)[-1]
    assert math.hypot(*last.position[:2]) <= 2 * TICK


def test_the_twist_is_that_of_the_last_period():
    """Within a tick per period."""
    for row in drive(EncoderOdometry(), 0.5, 1.0):
        assert row.linear == (pytest.approx(0.5, abs=TICK / PERIOD), 0.0, 0.0)
        error = 2 * TICK / PERIOD / WHEEL_SEPARATION
        assert row.angular == (0.0, 0.0, pytest.approx(1.0, abs=error))


@pytest.mark.parametrize('odometry', [WorldOdometry(), EncoderOdometry(gyro=True, **{
    name: value for name, value in ERRORS.items() if name != 'gyro_noise'})])
def test_at_rest_the_odometry_does_not_change(odometry):
    """Not even with noisy wheels: they do not turn."""
    assert len(set(drive(odometry, 0.0))) == 1


@pytest.mark.parametrize('slip', [0.01, 0.1, 0.5])
def test_slip_shows_as_way_that_was_not_gone(slip):
    """Of the way that the encoders count, a share of `slip` moved nothing."""
    whole = drive(EncoderOdometry(wheel_slip=slip), 0.5)[-1].position[0]
    assert whole * (1 - slip) == pytest.approx(5.0, abs=TICK)


@pytest.mark.parametrize('gyro', [False, True])
def test_without_noise_the_seed_makes_no_difference(gyro):
    """Noise that is off draws no dice."""
    tracks = {tuple(drive(EncoderOdometry(gyro, 0.01, seed=seed), 0.3, 0.5)) for seed in range(5)}
    assert len(tracks) == 1


def test_noise_is_the_same_with_the_same_seed_and_another_with_another():
    """So that a run can be repeated."""
    def run(seed):
        return tuple(drive(EncoderOdometry(True, seed=seed, **ERRORS), 0.3, 0.5))

    assert run(7) == run(7)
    assert len({run(seed) for seed in range(5)}) == 5


@pytest.mark.parametrize('speed, duration', [(0.5, 2.0), (0.5, 8.0), (0.125, 8.0)])
def test_wheel_noise_grows_with_the_root_of_the_way(speed, duration):
    """Each wheel has its own; the middle between two has half the variance."""
    ways = [distance(drive(EncoderOdometry(wheel_noise=0.02, seed=seed), speed, 0.0, duration))
            for seed in range(RUNS)]
    expected = 0.02 * math.sqrt(speed * duration / 2)
    assert statistics.stdev(ways) == pytest.approx(expected, rel=0.12)
    assert statistics.mean(ways) == pytest.approx(speed * duration, abs=4 * expected / RUNS**0.5)


@pytest.mark.parametrize('duration', [1.0, 4.0])
def test_gyro_noise_grows_with_the_root_of_time(duration):
    """Also while the robot stands, as a gyro's does."""
    yaws = [yaw_of(drive(EncoderOdometry(True, gyro_noise=0.02, seed=seed), 0.0, 0.0, duration)[-1]
                   .orientation) for seed in range(RUNS)]
    assert statistics.stdev(yaws) == pytest.approx(0.02 * math.sqrt(duration), rel=0.12)


@pytest.mark.parametrize('gyro, believed', [(False, 1.0), (True, 0.25)])
def test_with_the_gyro_the_yaw_is_that_of_the_body(gyro, believed):
    """Wheels that turn against each other on ice turn the robot less than they say."""
    odometry = EncoderOdometry(gyro)
    odometry.reset(motion(), (0.0, 0.0))
    now = odometry.update(motion(yaw=0.25), lambda: wheel_angles(0.0, 1.0), PERIOD)
    assert yaw_of(now.orientation) == pytest.approx(believed, abs=2 * TICK / WHEEL_SEPARATION)
    assert now.angular[2] == pytest.approx(believed / PERIOD, rel=1e-3)


def test_the_gyro_turns_on_past_half_a_circle():
    """The yaw of the body leaps from pi to -pi, and its turn does not."""
    for row in drive(EncoderOdometry(gyro=True), 0.0, 2.0):
        assert row.angular[2] == pytest.approx(2.0)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_starts_from_zero_wherever_the_wheels_are(gyro):
    """And the next odometry counts from there."""
    odometry = EncoderOdometry(gyro)
    drive(odometry, 0.5, 1.0)
    first = odometry.reset(motion(3.0, 4.0, 2.0), (1000.0, -50.0))
    assert first == motion()
    angles = [old + way for old, way in zip((1000.0, -50.0), wheel_angles(0.5, 0.0))]
    now = odometry.update(motion(3.5, 4.0, 2.0), lambda: angles, PERIOD)
    assert now.position == pytest.approx((0.5, 0.0, 0.0), abs=2 * TICK)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_on_the_way_does_not_show_in_the_velocity(gyro):
    """The wheels go on, and what they turned since the last odometry counts."""
    odometry = EncoderOdometry(gyro)
    drive(odometry, 0.5, 0.4, duration=2.0)
    odometry.reset(motion(*on_arc(0.5, 0.4, 2.0)))
    now = odometry.update(motion(*on_arc(0.5, 0.4, 2.0 + PERIOD)),
                          lambda: wheel_angles(0.5 * (2 + PERIOD), 0.4 * (2 + PERIOD)), PERIOD)
    assert now.linear[0] == pytest.approx(0.5, abs=2 * TICK / PERIOD)
    assert now.angular[2] == pytest.approx(0.4, abs=2 * TICK / WHEEL_SEPARATION / PERIOD)


@pytest.mark.parametrize('odometry, variances', [
    (WorldOdometry(), (1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001)),
    (EncoderOdometry(), (0.1, 0.1, 1e10, 1e10, 1e10, 0.2)),
    (EncoderOdometry(gyro=True), (0.1, 0.1, 1e10, 1e10, 1e10, 0.05))])
def test_the_covariance_is_that_of_the_tutorial_or_of_a_kobuki(odometry, variances):
    """Of x, y, z, roll, pitch and yaw; a huge one means unknown."""
    assert odometry.covariance == variances
