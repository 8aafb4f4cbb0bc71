"""Where a robot believes it is after motions that are made up here."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from odometry_common.geometry import yaw_of
from odometry_common.kobuki import WHEEL_SEPARATION
from odometry_tests.arcs import PERIOD, TICK, drive, motion, on_arc, wheel_angles
from sim_turtlebot.odometry import STILL, EncoderOdometry, Motion, WorldOdometry

places = st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4), st.floats(-3.1, 3.1))
speeds = st.floats(-0.7, 0.7)
turn_speeds = st.floats(-math.pi, math.pi)


def at_zero():
    """Return the angles of wheels that have not turned."""
    return 0.0, 0.0


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


TILTED = Motion((1.0, 2.0, 0.03), (0.1, 0.0, 0.0, math.sqrt(0.99)), (0.2, 0.01, 0), (0, 0, 1))


def test_world_odometry_keeps_height_and_tilt():
    """The tutorial's /odom is a full pose."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, 0.5))
    now = odometry.update(TILTED, at_zero, PERIOD)
    assert now.position[2] == pytest.approx(0.03)
    assert math.hypot(*now.orientation[:2]) == pytest.approx(0.1)


def test_the_twist_of_world_odometry_is_the_mean_since_the_last_message():
    """In the frame of the base, whatever the velocity is at the moment of the message."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, math.pi / 2))
    now = odometry.update(motion(1.0, 2.02, math.pi / 2)._replace(linear=(0.1, 0.0, 0.0)),
                          at_zero, 0.1)
    assert now.linear == pytest.approx((0.2, 0.0, 0.0), abs=1e-12)
    assert now.angular == pytest.approx(STILL, abs=1e-12)


def test_over_a_long_time_the_twist_is_that_of_the_moment():
    """The mean of a second says little of the velocity, and a turn may be more than half."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, 0.5))
    now = odometry.update(TILTED, at_zero, 1.0)
    assert (now.linear, now.angular) == (TILTED.linear, TILTED.angular)


def test_a_robot_at_rest_is_at_rest_even_where_it_has_been_put():
    """What stands has no velocity, also in the message after it has come to rest."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, 0.5))
    now = odometry.update(motion(1.1, 2.0, 0.5)._replace(linear=STILL, angular=STILL), at_zero, PERIOD)
    assert (now.linear, now.angular) == (STILL, STILL)


@given(speeds)
def test_straight_on_the_encoders_are_right_to_a_tick(speed):
    """However long the path: what is not yet a tick is not lost."""
    last = drive(EncoderOdometry(gyro=False), speed)[-1]
    assert abs(last.position[0] - speed * 10) <= TICK
    assert last.position[1:] == (0.0, 0.0)
    assert last.orientation == (0.0, 0.0, 0.0, 1.0)


@given(speeds, turn_speeds)
@example(0.0, 0.6 * math.pi)  # a spin, which leaves x and y at zero
@example(-0.0005763755745385824, 2.7192147642655984)  # all but a spin: ticks are all its error
def test_on_an_arc_the_encoders_keep_to_the_closed_form(speed, turn_speed):
    """Yaw to a tick of each wheel; the position to what that yaw, the chords and the ticks allow."""
    x, y, yaw = on_arc(speed, turn_speed, 10.0)
    last = drive(EncoderOdometry(gyro=False), speed, turn_speed)[-1]
    yaw_error = 2 * TICK / WHEEL_SEPARATION
    assert abs(math.remainder(yaw_of(last.orientation) - yaw, 2 * math.pi)) <= yaw_error
    chord = (turn_speed * PERIOD)**2 / 24  # share by which an arc is longer than its chord
    travel = abs(speed) * 10
    # The wheels' mean travel is up to a tick behind. Summed by parts about the middle of that, it
    # is a tick for the two ends, and half of one for each radian the robot turns between them.
    turned = abs(turn_speed) * 10 + yaw_error * 10 / PERIOD
    ticks = TICK * (1 + turned / 2)
    bound = travel * (yaw_error + chord) + ticks
    assert math.dist(last.position[:2], (x, y)) <= bound


def test_the_twist_is_that_of_the_last_period():
    """Within a tick per period."""
    for row in drive(EncoderOdometry(gyro=False), 0.5, 1.0):
        assert row.linear == (pytest.approx(0.5, abs=TICK / PERIOD), 0.0, 0.0)
        error = 2 * TICK / PERIOD / WHEEL_SEPARATION
        assert row.angular == (0.0, 0.0, pytest.approx(1.0, abs=error))


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_starts_from_zero_wherever_the_wheels_are(gyro):
    """And the next odometry counts from there."""
    odometry = EncoderOdometry(gyro)
    drive(odometry, 0.5, 1.0)
    first = odometry.reset(motion(3.0, 4.0, 2.0), (1000.0, -50.0))
    assert first == motion()
    angles = [old + turned for old, turned in zip((1000.0, -50.0), wheel_angles(0.5, 0.0))]
    now = odometry.update(motion(3.5, 4.0, 2.0), lambda: angles, PERIOD)
    assert now.position == pytest.approx((0.5, 0.0, 0.0), abs=2 * TICK)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_while_driving_does_not_show_in_the_velocity(gyro):
    """The wheels go on, and what they turned since the last odometry counts."""
    odometry = EncoderOdometry(gyro)
    drive(odometry, 0.5, 0.4, duration=2.0)
    odometry.reset(motion(*on_arc(0.5, 0.4, 2.0)))
    now = odometry.update(motion(*on_arc(0.5, 0.4, 2.0 + PERIOD)),
                          lambda: wheel_angles(0.5 * (2 + PERIOD), 0.4 * (2 + PERIOD)), PERIOD)
    assert now.linear[0] == pytest.approx(0.5, abs=2 * TICK / PERIOD)
    assert now.angular[2] == pytest.approx(0.4, abs=2 * TICK / WHEEL_SEPARATION / PERIOD)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_robot_that_is_carried_is_where_it_was_by_its_encoders(gyro):
    """Its gyro, if it has one, notices that it was turned; nothing has a speed."""
    odometry = EncoderOdometry(gyro)
    odometry.reset(motion(1.0, 2.0, 0.5), at_zero())
    before = odometry.update(motion(1.5, 2.0, 0.5), lambda: wheel_angles(0.5, 0.0), PERIOD)
    carried = odometry.carry(motion(-3.0, 7.0, 2.5))
    assert carried.position == before.position
    assert yaw_of(carried.orientation) == pytest.approx(2.0 if gyro else 0.0)
    assert (carried.linear, carried.angular) == (STILL, STILL)
    after = odometry.update(motion(-3.0, 7.0, 2.5), lambda: wheel_angles(0.5, 0.0), PERIOD)
    assert after == carried._replace(linear=after.linear, angular=after.angular)
    assert (after.linear, after.angular) == (STILL, STILL)


def test_world_odometry_jumps_with_the_robot():
    """As Gazebo's does."""
    odometry = WorldOdometry()
    odometry.reset(motion(1.0, 2.0, 0.0))
    assert odometry.carry(motion(4.0, 2.0, 1.0)).position == (3.0, 0.0, 0.0)


@pytest.mark.parametrize('odometry, variances', [
    (WorldOdometry(), (1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001)),
    (EncoderOdometry(gyro=False), (0.1, 0.1, 1e10, 1e10, 1e10, 0.2)),
    (EncoderOdometry(), (0.1, 0.1, 1e10, 1e10, 1e10, 0.05))])
def test_the_covariance_is_that_of_the_tutorial_or_of_a_kobuki(odometry, variances):
    """Of x, y, z, roll, pitch and yaw; a huge one means unknown."""
    assert odometry.covariance == variances
