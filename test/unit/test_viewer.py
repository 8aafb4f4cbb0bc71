"""What the browser window computes: a robot's way, the clock's rate, who holds the pad."""

import math

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sim_turtlebot.viewer.pad import (
    BACK,
    COMMAND_PERIOD,
    FORWARD,
    HOLD_RATE,
    HOLD_TIMEOUT,
    LEFT,
    STANDSTILL,
    STOP,
    Holds,
    Steering,
)
from sim_turtlebot.viewer.track import ORIGIN, Pose, RateGauge, Samples, Track

PERIOD = 0.05  # s
COORDINATES = st.floats(-100, 100)
POSES = st.builds(Pose, COORDINATES, COORDINATES, st.floats(-10, 10))


def follow(track, poses, start=0.0, truth=None):
    """Let a track see an odometry pose each period, and true poses with the same stamps."""
    for index, pose in enumerate(poses):
        stamp = start + PERIOD * index
        track.add_odometry(stamp, pose)
        if truth:
            track.add_truth(stamp, truth[index])


def straight(metres, steps=20, scale=1.0):
    """Return poses along the x axis."""
    return [Pose(scale * metres * step / steps, 0.0, 0.0) for step in range(steps + 1)]


@given(POSES, POSES)
def test_a_pose_seen_from_itself_is_the_origin(pose, other):
    """And going there and back leads nowhere."""
    assert pose.inverse().then(pose) == pytest.approx(ORIGIN, abs=1e-9)
    assert pose.then(pose.inverse().then(other)) == pytest.approx(other, abs=1e-9)


@given(st.lists(st.floats(0.001, 1), min_size=1, max_size=500))
def test_samples_cover_the_whole_run_within_their_limit(steps):
    """However long it is, the first and almost the last place are kept."""
    samples = Samples(0.01, 1, limit=50)
    place = 0.0
    for step in steps:
        samples.add(place, [place])
        place += step
    kept = samples.array()[:, 0]
    assert 1 <= len(kept) <= 50 + 1
    assert kept[0] == 0.0
    assert (numpy.diff(kept) > 0).all()
    assert place - kept[-1] <= max(2.0, 6 * place / 50)


def test_without_truth_the_odometry_is_drawn():
    """As of a real robot."""
    track = Track()
    follow(track, straight(1.0))
    assert track.true_distance is None
    assert track.origin == ORIGIN
    assert track.trail.array()[-1].tolist() == [1.0, 0.0]


def test_the_odometry_begins_where_the_robot_is_in_the_world():
    """Its frame is put where truth and odometry agree at first."""
    start = Pose(5.0, -3.0, math.pi / 2)
    track = Track()
    way = straight(1.0)
    follow(track, way, truth=[start.then(pose) for pose in way])
    assert track.origin == pytest.approx(start)
    assert track.true_distance == pytest.approx(1.0)
    assert track.drift == pytest.approx(ORIGIN, abs=1e-9)
    assert track.trail.array()[-1] == pytest.approx([5.0, -2.0])


def test_slipping_wheels_show_as_drift():
    """The odometry counts a metre, and the robot goes nine tenths of it."""
    track = Track()
    follow(track, straight(1.0), truth=straight(1.0, scale=0.9))
    assert track.drift == pytest.approx((-0.1, 0.0, 0.0))
    assert track.true_distance == pytest.approx(0.9)


def test_poses_of_different_moments_are_not_compared():
    """A robot that moves would seem to drift."""
    track = Track()
    follow(track, straight(1.0), truth=straight(1.0))
    track.add_odometry(10.0, Pose(1.2, 0.0, 0.0))
    assert track.drift == pytest.approx(ORIGIN)


@pytest.mark.parametrize('stamp, why', [(0.0, 'time goes back'), (1.05, 'the robot jumps')])
def test_a_reset_begins_a_new_track(stamp, why):
    """Trail, distance and origin are those of the new run."""
    track = Track()
    follow(track, straight(1.0), truth=straight(1.0))
    follow(track, [ORIGIN, Pose(0.01, 0.0, 0.0)], stamp, truth=[ORIGIN, Pose(0.01, 0.0, 0.0)])
    assert track.true_distance == pytest.approx(0.01), why
    assert track.trail.array()[0].tolist() == [0.0, 0.0]
    assert len(track.trail.array()) == 2


def test_a_heading_goes_on_beyond_half_a_turn():
    """A plot of it has no jumps, and the target is that turn of it which is nearest."""
    track = Track()
    turns = [math.radians(degrees) for degrees in range(0, 721, 10)]
    follow(track, [Pose(0.0, 0.0, math.remainder(yaw, 2 * math.pi)) for yaw in turns])
    track.note(1.0, None, 90.0)
    _, moved, true, heading, target = track.history.array()[-1]
    assert heading == pytest.approx(720)
    assert target == pytest.approx(810)
    assert math.isnan(moved) and math.isnan(true)


def test_the_gauge_tells_the_rate_of_a_clock():
    """Too early to tell, then the rate, then none at a standstill; a reset begins anew."""
    gauge = RateGauge(window=2.0)
    rates = [gauge.rate(now * 0.1, now * 0.3) for now in range(50)]
    assert rates[:10] == [None] * 10
    assert rates[20:] == pytest.approx([3.0] * 30)
    assert [gauge.rate(5.0 + now * 0.1, 14.7) for now in range(30)][-1] == 0.0
    assert gauge.rate(8.0, 0.0) is None


def test_a_hold_lasts_until_it_is_released_or_no_more_is_heard():
    """A page that has gone cannot say so."""
    holds = Holds()
    holds.hold('page', FORWARD, 0.0)
    assert holds.command(HOLD_TIMEOUT - 0.01) == (1, 0)
    assert holds.command(HOLD_TIMEOUT + 0.01) is None
    holds.hold('page', FORWARD, 1.0)
    holds.release('page', FORWARD)
    assert holds.command(1.0) is None


def test_what_is_held_adds_up():
    """Forward and left is a curve, forward and back is a standstill."""
    holds = Holds()
    holds.hold('page', FORWARD, 0.0)
    holds.hold('page', LEFT, 0.0)
    assert holds.command(0.1) == (1, 1)
    holds.release('page', LEFT)
    holds.hold('page', BACK, 0.0)
    assert holds.command(0.1) == (0, 0)


def test_pages_hold_by_themselves():
    """Two that hold the same do not double it; one that goes leaves the other's."""
    holds = Holds()
    holds.hold('one', FORWARD, 0.0)
    holds.hold('other', FORWARD, 0.0)
    assert holds.command(0.1) == (1, 0)
    holds.release('one')
    assert holds.command(0.1) == (1, 0)
    holds.clear()
    assert holds.command(0.1) is None


def test_stop_overrules_whatever_is_held():
    """On whichever page."""
    holds = Holds()
    holds.hold('one', FORWARD, 0.0)
    holds.hold('other', STOP, 0.0)
    assert holds.command(0.1) == (0, 0)


def test_a_page_that_hangs_drives_no_longer_than_a_hold_lasts():
    """The last word is one zero; until then the robot is told all the time."""
    steering = Steering()
    steering.choose('')
    steps_between_holds = round(1 / HOLD_RATE / COMMAND_PERIOD)
    hangs_after = 20
    heard = []
    for step in range(hangs_after + 100):
        now = COMMAND_PERIOD * step
        if step <= hangs_after and step % steps_between_holds == 0:
            steering.hold('page', FORWARD, now)
        heard.append(steering.commands(now))
    last = heard.index([('', STANDSTILL)])
    assert (last - hangs_after) * COMMAND_PERIOD == pytest.approx(HOLD_TIMEOUT, abs=COMMAND_PERIOD)
    assert heard[:last] == [[('', (1, 0))]] * last
    assert not any(heard[last + 1:])


def test_a_release_is_one_zero_at_once():
    """And nothing after it."""
    steering = Steering()
    steering.choose('')
    steering.hold('page', LEFT, 0.0)
    assert steering.commands(0.0) == [('', (0, 1))] and steering.is_driving
    steering.release('page', LEFT)
    assert steering.commands(0.0) == [('', STANDSTILL)] and not steering.is_driving
    assert steering.commands(0.0) == []


def test_another_robot_is_not_driven_before_the_first_one_stands():
    """Who changes the robot lets go of the old one's button."""
    steering = Steering()
    steering.choose('robot_1/')
    steering.hold('page', FORWARD, 0.0)
    steering.commands(0.0)
    steering.choose('robot_2/')
    steering.hold('page', FORWARD, 0.1)
    assert steering.commands(0.1) == [('robot_1/', STANDSTILL), ('robot_2/', (1, 0))]


def test_without_a_robot_nothing_is_commanded():
    """A page may be there first."""
    steering = Steering()
    steering.hold('page', FORWARD, 0.0)
    assert steering.commands(0.0) == [] and not steering.is_driving
