"""Where a robot believes it is after motions that are made up here."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from odometry_common.geometry import about_z, yaw_of
from odometry_common.kobuki import WHEEL_SEPARATION
from odometry_tests.arcs import PERIOD, TICK, Robot, drive, motion, on_arc, wheel_angles
from sim_turtlebot.odometry import STILL, Motion

places = st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4), st.floats(-3.1, 3.1))
speeds = st.floats(-0.7, 0.7)
turn_speeds = st.floats(-math.pi, math.pi)


def encoders(gyro=False):
    return Robot(odometry_source='encoder', gyro=gyro)


@given(places, places)
def test_world_odometry_is_the_pose_seen_from_the_start(start, place):
    """At the start it is zero, whichever way the robot was put down."""
    robot = Robot()
    first = robot.start(motion(*start))
    assert first.position == pytest.approx(STILL, abs=1e-12)
    assert yaw_of(first.orientation) == pytest.approx(0, abs=1e-12)
    now = robot.move(motion(*place))
    x, y = place[0] - start[0], place[1] - start[1]
    cos, sin = math.cos(start[2]), math.sin(start[2])
    assert now.position == pytest.approx((x * cos + y * sin, y * cos - x * sin, 0), abs=1e-9)
    turn = math.remainder(yaw_of(now.orientation) - (place[2] - start[2]), 2 * math.pi)
    assert turn == pytest.approx(0, abs=1e-9)


TILTED = Motion((1.0, 2.0, 0.03), (0.1, 0.0, 0.0, math.sqrt(0.99)), (0.2, 0.01, 0), (0, 0, 1))


def test_world_odometry_keeps_height_and_tilt():
    """The tutorial's /odom is a full pose."""
    robot = Robot()
    robot.start(motion(1.0, 2.0, 0.5))
    now = robot.move(TILTED)
    assert now.position[2] == pytest.approx(0.03)
    assert math.hypot(*now.orientation[:2]) == pytest.approx(0.1)


def test_the_twist_of_world_odometry_is_the_mean_since_the_last_message():
    """In the frame of the base, whatever the velocity is at the moment of the message."""
    robot = Robot()
    robot.start(motion(1.0, 2.0, math.pi / 2))
    now = robot.move(motion(1.0, 2.02, math.pi / 2)._replace(linear=(0.1, 0.0, 0.0)),
                     duration=0.1)
    assert now.linear == pytest.approx((0.2, 0.0, 0.0), abs=1e-12)
    assert now.angular == pytest.approx(STILL, abs=1e-12)


def test_over_a_long_time_the_twist_is_that_of_the_moment():
    """The mean of a second says little of the velocity, and a turn may be more than half."""
    robot = Robot()
    robot.start(motion(1.0, 2.0, 0.5))
    now = robot.move(TILTED, duration=1.0)
    assert (*now.linear, *now.angular) == pytest.approx((*TILTED.linear, *TILTED.angular))


def test_a_robot_at_rest_is_at_rest_even_where_it_has_been_put():
    """What stands has no velocity, also in the message after it has come to rest."""
    robot = Robot()
    robot.start(motion(1.0, 2.0, 0.5))
    now = robot.move(motion(1.1, 2.0, 0.5)._replace(linear=STILL, angular=STILL))
    assert (now.linear, now.angular) == (STILL, STILL)


@given(speeds)
def test_straight_on_the_encoders_are_right_to_a_tick(speed):
    """However long the path: what is not yet a tick is not lost."""
    last = drive(encoders(), speed)[-1]
    assert abs(last.position[0] - speed * 10) <= TICK
    assert last.position[1:] == (0.0, 0.0)
    assert last.orientation == (0.0, 0.0, 0.0, 1.0)


@given(speeds, turn_speeds)
@example(0.0, 0.6 * math.pi)  # a spin, which leaves x and y at zero
@example(-0.0005763755745385824, 2.7192147642655984)  # all but a spin: ticks are all its error
def test_on_an_arc_the_encoders_keep_to_the_closed_form(speed, turn_speed):
    """Yaw to a tick of each wheel; the position to what that yaw, the chords and the ticks allow."""
    x, y, yaw = on_arc(speed, turn_speed, 10.0)
    last = drive(encoders(), speed, turn_speed)[-1]
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


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_starts_from_zero_wherever_the_wheels_are(gyro):
    robot = encoders(gyro)
    drive(robot, 0.5, 1.0)
    first = robot.start(motion(3.0, 4.0, 2.0), (1000.0, -50.0))
    assert first == motion()
    angles = [old + turned for old, turned in zip((1000.0, -50.0), wheel_angles(0.5, 0.0))]
    now = robot.move(motion(3.5, 4.0, 2.0), angles)
    assert now.position == pytest.approx((0.5, 0.0, 0.0), abs=2 * TICK)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_reset_while_driving_does_not_show_in_the_velocity(gyro):
    """The wheels go on, and what they turned since the last odometry counts."""
    robot = encoders(gyro)
    drive(robot, 0.5, 0.4, duration=2.0)
    robot.reset_odometry()
    now = robot.move(motion(*on_arc(0.5, 0.4, 2.0 + PERIOD)),
                          wheel_angles(0.5 * (2 + PERIOD), 0.4 * (2 + PERIOD)))
    assert now.linear[0] == pytest.approx(0.5, abs=2 * TICK / PERIOD)
    assert now.angular[2] == pytest.approx(0.4, abs=2 * TICK / WHEEL_SEPARATION / PERIOD)


@pytest.mark.parametrize('gyro', [False, True])
def test_a_robot_that_is_carried_is_where_it_was_by_its_encoders(gyro):
    """Its gyro, if it has one, notices that it was turned; nothing has a speed."""
    robot = encoders(gyro)
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


@pytest.mark.parametrize('robot, variances', [
    (Robot(), (1e-05, 1e-05, 1e12, 1e12, 1e12, 0.001)),
    (encoders(), (0.1, 0.1, 1e10, 1e10, 1e10, 0.2)),
    (encoders(gyro=True), (0.1, 0.1, 1e10, 1e10, 1e10, 0.05))], ids=['world', 'wheels', 'gyro'])
def test_the_covariance_is_that_of_the_tutorial_or_of_a_kobuki(robot, variances):
    """Of x, y, z, roll, pitch and yaw; a huge one means unknown."""
    assert robot.covariance == variances
