"""What the page computes from a robot's poses, scans, maps and parameters."""

import math

import numpy
import pytest
from nav_msgs.msg import OccupancyGrid
from robot_view.monitor import scan_points
from robot_view.navigation import HEIGHT, occupied_cells
from robot_view.path_trace import ORIGIN, PathTrace, Samples
from sensor_msgs.msg import LaserScan
from sim_turtlebot.geometry import PlanarPose
from sim_turtlebot.kobuki import DEPTH_CAMERA

PERIOD = 0.05  # s


def follow(trace, poses, start=0.0, ground_truth=None):
    for index, pose in enumerate(poses):
        stamp = start + PERIOD * index
        trace.add_odometry(stamp, pose)
        if ground_truth:
            trace.add_ground_truth(stamp, ground_truth[index])


def straight(metres):
    return [PlanarPose(metres * step / 20, 0.0, 0.0) for step in range(21)]


def test_samples_cover_the_whole_run_evenly_within_their_limit():
    """However long it is, from the first to almost the last place."""
    samples = Samples(1, limit=50)
    for place in range(1000):
        samples.add(place, [place])
    kept = samples.array()[:, 0]
    assert 25 <= len(kept) <= 50 + 1
    assert kept[0] == 0 and len(set(numpy.diff(kept))) == 1
    assert kept[-1] > 1000 - 1000 / 25


def test_the_odometry_begins_where_the_robot_is_in_the_world():
    """Its frame is put where both agree at first; then wheels that slip show as drift. A late recording says so."""
    start = PlanarPose(5.0, -3.0, math.pi / 2)
    trace = PathTrace()
    follow(trace, [PlanarPose(3.0 + pose.x, 0.0, 0.0) for pose in straight(1.0)], start=7.0,
           ground_truth=[start.then(pose) for pose in straight(0.9)])
    assert trace.origin == pytest.approx((5.0, -6.0, math.pi / 2)) and trace.since == 7.0
    assert trace.true_distance == trace.true_from_start == pytest.approx(0.9)
    assert trace.drift == pytest.approx((-0.1, 0.0, 0.0))
    assert trace.trail.array()[-1] == pytest.approx([5.0, -2.1])


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
    follow(trace, [PlanarPose(0.0, 0.0, math.remainder(yaw, math.tau)) for yaw in turns])
    trace.add_history(None, 90.0)
    _, moved, true, heading, target = trace.history.array()[-1]
    assert heading == pytest.approx(720)
    assert target == pytest.approx(810)
    assert math.isnan(moved) and math.isnan(true)


def scan(*ranges, frame='camera_depth_frame'):
    message = LaserScan(ranges=ranges, angle_min=-math.pi / 2, angle_increment=math.pi / 2,
                        range_min=0.5, range_max=4.0)
    message.header.frame_id = frame
    return message


def test_each_range_is_a_point_seen_from_the_camera():
    """Where nothing was seen, and of an unknown origin, there is none."""
    expected = numpy.array([(0, -1, 0), (2, 0, 0), (0, 4, 0)]) + DEPTH_CAMERA
    for frame in 'camera_depth_frame', '/camera_depth_frame', 'robot_2/camera_depth_frame':
        assert scan_points(scan(1.0, 2.0, 4.0, frame=frame)) == pytest.approx(expected)
    for nothing in math.inf, -math.inf, math.nan, 0.4, 4.1, -1.0:
        assert scan_points(scan(nothing, 2.0, nothing)) == pytest.approx(expected[1:2]), nothing
    assert scan_points(scan(1.0, 2.0, 3.0, frame='laser')).shape == (0, 3)


@pytest.mark.parametrize('field', ['angle_min', 'angle_increment', 'range_max'])
@pytest.mark.parametrize('value', [math.nan, math.inf])
def test_every_point_is_finite(field, value):
    message = scan(1.0, math.inf, 3.0)
    setattr(message, field, value)
    assert numpy.isfinite(scan_points(message)).all()


def test_a_maps_occupied_cells_are_where_it_has_them():
    grid = OccupancyGrid(data=[0, 100, -1, 0, 0, 65])
    grid.info.width, grid.info.height, grid.info.resolution = 3, 2, 0.5
    grid.info.origin.position.x, grid.info.origin.position.y = -1.0, 2.0
    assert occupied_cells(grid).tolist() == [[-0.25, 2.25, HEIGHT], [0.25, 2.75, HEIGHT]]
    grid.data.pop()
    with pytest.raises(ValueError, match='reshape'):
        occupied_cells(grid)
