"""What the page computes from the poses of a robot."""

import math

import numpy
import pytest
from odometry_common.geometry import PlanarPose
from robot_view.path_trace import ORIGIN, PathTrace, Samples

PERIOD = 0.05  # s


def follow(trace, poses, start=0.0, ground_truth=None):
    for index, pose in enumerate(poses):
        stamp = start + PERIOD * index
        trace.add_odometry(stamp, pose)
        if ground_truth:
            trace.add_ground_truth(stamp, ground_truth[index])


def straight(metres, steps=20, scale=1.0):
    return [PlanarPose(scale * metres * step / steps, 0.0, 0.0) for step in range(steps + 1)]


def test_samples_cover_the_whole_run_evenly_within_their_limit():
    """However long it is, from the first to almost the last place."""
    samples = Samples(1, 1, limit=50)
    for place in range(1000):
        samples.add(place, [place])
    kept = samples.array()[:, 0]
    assert 25 <= len(kept) <= 50 + 1
    assert kept[0] == 0 and len(set(numpy.diff(kept))) == 1
    assert kept[-1] > 1000 - 1000 / 25


def test_the_odometry_begins_where_the_robot_is_in_the_world():
    """Its frame is put where ground truth and odometry agree at first."""
    start = PlanarPose(5.0, -3.0, math.pi / 2)
    trace = PathTrace()
    path = straight(1.0)
    follow(trace, path, ground_truth=[start.then(pose) for pose in path])
    assert trace.origin == pytest.approx(start)
    assert trace.true_distance == pytest.approx(1.0)
    assert trace.drift == pytest.approx(ORIGIN, abs=1e-9)
    assert trace.trail.array()[-1] == pytest.approx([5.0, -2.0])


def test_what_nobody_saw_is_not_counted():
    """A recording that begins late says since when; the wheels may have slipped before."""
    trace = PathTrace()
    follow(trace, [PlanarPose(3.0 + pose.x, 0.0, 0.0) for pose in straight(1.0)], start=7.0,
           ground_truth=straight(0.5))
    assert trace.true_distance == pytest.approx(0.5)
    assert trace.since == 7.0


def test_slipping_wheels_show_as_drift():
    """The odometry counts a metre, and the robot goes nine tenths of it."""
    trace = PathTrace()
    follow(trace, straight(1.0), ground_truth=straight(1.0, scale=0.9))
    assert trace.drift == pytest.approx((-0.1, 0.0, 0.0))
    assert trace.since is None
    assert trace.true_distance == pytest.approx(0.9)


def test_poses_of_different_moments_are_not_compared():
    trace = PathTrace()
    follow(trace, straight(1.0), ground_truth=straight(1.0))
    trace.add_odometry(10.0, PlanarPose(1.2, 0.0, 0.0))
    assert trace.drift == pytest.approx(ORIGIN)


@pytest.mark.parametrize('stamp', [0.0, 1.05])
def test_a_reset_begins_a_new_trace(stamp):
    real, simulated = PathTrace(), PathTrace()
    follow(real, straight(1.0))
    follow(simulated, straight(1.0), ground_truth=straight(1.0))
    real.add_odometry(stamp, ORIGIN)
    simulated.add_ground_truth(stamp, ORIGIN)
    assert real.trail.array().tolist() == simulated.trail.array().tolist() == [[0.0, 0.0]]
    assert simulated.true_distance is None


def test_a_heading_goes_on_beyond_half_a_turn():
    """A plot of it has no jumps, and the target is that turn of it which is nearest."""
    trace = PathTrace()
    turns = [math.radians(degrees) for degrees in range(0, 721, 10)]
    follow(trace, [PlanarPose(0.0, 0.0, math.remainder(yaw, 2 * math.pi)) for yaw in turns])
    trace.add_history(1.0, None, 90.0)
    _, moved, true, heading, target = trace.history.array()[-1]
    assert heading == pytest.approx(720)
    assert target == pytest.approx(810)
    assert math.isnan(moved) and math.isnan(true)
