"""Bags that have no run, or in which a stranger defines the messages."""

import pytest
import rosbag
from odometry_tools.runs.recorded_run import BagError, read_run
from recorded_bags import metre, plot, record, write_foreign, write_without_speed
from std_msgs.msg import Float64


@pytest.mark.parametrize('write, lines', [
    (lambda path: path.write_bytes(b'no bag at all'), 'cannot be read'),
    (lambda path: rosbag.Bag(str(path), 'w').flush(), "is not indexed: rosbag reindex '{}'"),
    (lambda path: path.write_bytes(b'\xff' * 1000), 'is damaged: UnicodeDecodeError('),
    (write_without_speed, 'has no message with finite numbers on /odom')])
def test_a_file_without_a_run_is_refused(tmp_path, write, lines):
    """With status 2 and one line that names it, and the cure if there is one."""
    path = tmp_path / 'broken off.bag'
    write(path)
    run = plot(path, status=2)
    assert len(run.stderr.splitlines()) == 1 and str(path) in run.stderr, run.stderr
    assert lines.format(path) in run.stderr and len(run.stderr) < len(str(path)) + 150


def test_of_several_odometries_the_user_has_to_choose(tmp_path):
    path = record(tmp_path / 'two.bag', metre(), '/b/odom')
    record(path, metre()[:1], '/a/odom', 'a')
    with pytest.raises(BagError, match='no messages on /odom; choose its odometry: --topic /a/odom '
                                       'or --topic /b/odom$'):
        read_run(path)
    assert read_run(path, '/b/odom').odometry.distance[-1] == pytest.approx(1.0)


def test_only_the_odometry_needs_the_right_type(tmp_path):
    path = record(tmp_path / 'odd.bag', metre())
    for topic in '/cmd_vel', '/base_pose_ground_truth':
        record(path, [Float64()], topic, 'a')
    run = read_run(path)
    assert run.ground_truth is None and not len(run.commands)
    with pytest.raises(BagError, match='odd.bag has std_msgs/Float64 on /cmd_vel; choose'):
        read_run(path, '/cmd_vel')


def test_a_definition_in_a_bag_does_not_run(tmp_path):
    path = write_foreign(tmp_path / 'stranger.bag', '/base_pose_ground_truth', tmp_path / 'ran')
    run = plot('--topic', '/odom', path)
    assert 'left out    /base_pose_ground_truth, defined differently from the installed message' in run.stdout
    assert not run.stderr and not (tmp_path / 'ran').exists()


def test_an_index_that_points_to_a_foreign_definition_does_not_run_it(tmp_path):
    path = write_foreign(tmp_path / 'lying.bag', '/x', tmp_path / 'ran')
    with rosbag.Bag(str(path)) as bag, pytest.raises(
            rosbag.ROSBagException, match='a message is of the type nav_msgs/Odometry'):
        list(bag.read_messages('/x'))
    assert not (tmp_path / 'ran').exists()


def test_odometry_that_is_defined_differently_or_absent_is_named(tmp_path):
    path = write_foreign(tmp_path / 'other.bag', '/b/odom', tmp_path / 'ran')
    with pytest.raises(BagError, match='other.bag defines nav_msgs/Odometry on /b/odom differently'):
        read_run(path, '/b/odom')
    with pytest.raises(BagError, match='other.bag has 0 messages on /odom'):
        read_run(path, '/odom', end=0.0)
    assert not (tmp_path / 'ran').exists()
