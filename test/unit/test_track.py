"""What the page computes of a robot: its track, and the rate of its clock."""

import math

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.geometry import PlanarPose
from robot_view.track import ORIGIN, RateGauge, Samples, Track

PERIOD = 0.05  # s


def follow(track, poses, start=0.0, ground_truth=None):
    """Let a track see an odometry pose each period, and true poses with the same stamps."""
    for index, pose in enumerate(poses):
        stamp = start + PERIOD * index
        track.add_odometry(stamp, pose)
        if ground_truth:
            track.add_ground_truth(stamp, ground_truth[index])


def straight(metres, steps=20, scale=1.0):
    """Return poses along the x axis."""
    return [PlanarPose(scale * metres * step / steps, 0.0, 0.0) for step in range(steps + 1)]


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


def test_without_ground_truth_the_odometry_is_drawn():
    """As of a real robot."""
    track = Track()
    follow(track, straight(1.0))
    assert track.true_distance is None
    assert track.origin == ORIGIN
    assert track.trail.array()[-1].tolist() == [1.0, 0.0]


def test_the_odometry_begins_where_the_robot_is_in_the_world():
    """Its frame is put where ground truth and odometry agree at first."""
    start = PlanarPose(5.0, -3.0, math.pi / 2)
    track = Track()
    path = straight(1.0)
    follow(track, path, ground_truth=[start.then(pose) for pose in path])
    assert track.origin == pytest.approx(start)
    assert track.true_distance == pytest.approx(1.0)
    assert track.drift == pytest.approx(ORIGIN, abs=1e-9)
    assert track.trail.array()[-1] == pytest.approx([5.0, -2.0])


def test_slipping_wheels_show_as_drift():
    """The odometry counts a metre, and the robot goes nine tenths of it."""
    track = Track()
    follow(track, straight(1.0), ground_truth=straight(1.0, scale=0.9))
    assert track.drift == pytest.approx((-0.1, 0.0, 0.0))
    assert track.true_distance == pytest.approx(0.9)


def test_poses_of_different_moments_are_not_compared():
    """A robot that moves would seem to drift."""
    track = Track()
    follow(track, straight(1.0), ground_truth=straight(1.0))
    track.add_odometry(10.0, PlanarPose(1.2, 0.0, 0.0))
    assert track.drift == pytest.approx(ORIGIN)


@pytest.mark.parametrize('stamp, why', [(0.0, 'time goes back'), (1.05, 'the robot jumps')])
def test_a_reset_begins_a_new_track(stamp, why):
    """Trail, distance and origin are those of the new run."""
    track = Track()
    follow(track, straight(1.0), ground_truth=straight(1.0))
    poses = [ORIGIN, PlanarPose(0.01, 0.0, 0.0)]
    follow(track, poses, stamp, ground_truth=poses)
    assert track.true_distance == pytest.approx(0.01), why
    assert track.trail.array()[0].tolist() == [0.0, 0.0]
    assert len(track.trail.array()) == 2


def test_a_heading_goes_on_beyond_half_a_turn():
    """A plot of it has no jumps, and the target is that turn of it which is nearest."""
    track = Track()
    turns = [math.radians(degrees) for degrees in range(0, 721, 10)]
    follow(track, [PlanarPose(0.0, 0.0, math.remainder(yaw, 2 * math.pi)) for yaw in turns])
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
