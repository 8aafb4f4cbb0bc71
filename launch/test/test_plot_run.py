"""The picture of a recorded run, and the figures that are printed with it."""

import math

import numpy
import pytest
import rosbag
import rospy
from odometry_launch.figure import make_figure
from odometry_launch.recorded_run import BagError, read_run
from odometry_tests.forms import number_after
from odometry_tests.messages import odometry
from odometry_tests.processes import Process
from std_msgs.msg import Float64

PNG = b'\x89PNG'
PERIOD = 0.1  # s
START = 100.0  # s


def metre():
    """Return odometry of a robot that goes a metre in ten seconds."""
    messages = [odometry(x=0.01 * step, stamp=START + PERIOD * step) for step in range(101)]
    for message in messages:
        message.twist.twist.linear.x = 0.1
    return messages


def record(path, messages, topic='/odom'):
    """Write a bag as a real robot's: without commands or the robot's true position."""
    with rosbag.Bag(str(path), 'w') as bag:
        for number, message in enumerate(messages):
            bag.write(topic, message, rospy.Time.from_sec(START + PERIOD * number))
    return path


def plot(*arguments, **options):
    """Run plot_run.py to its end."""
    run = Process('rosrun', 'odometry_launch', 'plot_run.py', *arguments, **options)
    run.wait(30.0)
    return run


def test_it_draws_any_bag_with_odometry(tmp_path):
    """A real robot's bag has neither truth nor commands. Jupyter and editors set MPLBACKEND.

    A driver's NaN is no position, and no top speed. The only odometry in a bag is taken by any name.
    """
    messages = metre()
    messages[0].pose.pose.position.x = math.nan
    messages[40].twist.twist.linear.x = math.nan
    messages[50].pose.pose.orientation.w = math.nan
    picture = tmp_path / 'real.png'
    messages.append(messages[60])  # late
    bag = record(tmp_path / 'real.bag', messages, '/robot_1/odom')
    run = plot(bag, '-o', picture, env={'MPLBACKEND': 'nonsense'})
    assert run.wait() == 0, run.output
    assert number_after('distance', run.stdout) == 0.99
    assert number_after('duration', run.stdout) == 9.9
    assert number_after('mean speed', run.stdout) == 0.1
    assert number_after('top speed', run.stdout) == 0.1
    assert 'odometry    /robot_1/odom\n' in run.stdout
    assert 'left out    4 messages ignored\n' in run.stdout
    assert picture.read_bytes().startswith(PNG)


def test_a_jump_is_no_distance_and_what_comes_after_the_end_is_left_out(tmp_path):
    """The robot is carried 50 m away and back; no line joins the places. A recording goes on."""
    messages = metre()
    for message in messages[20:30]:
        message.pose.pose.position.y = 50.0
    run = read_run(record(tmp_path / 'carried.bag', messages), end=START + 5.0)
    assert run.odometry.time[-1] == pytest.approx(5.0)
    assert run.odometry.distance[-1] == pytest.approx(0.48)
    assert 'left out    2 jumps not counted' in run.summary()
    _, drawn = make_figure(run).axes[0].lines[0].get_data()
    assert [len(part) for part in numpy.split(drawn, numpy.flatnonzero(numpy.isnan(drawn)))] == [
        20, 11, 22]


@pytest.mark.parametrize('length, drawn', [(0.5, False), (2.005, True), (100, False)])
def test_the_picture_names_the_bag_and_what_it_shows(tmp_path, length, drawn):
    """The line at two metres would lie on the axis of a long run."""
    messages = [odometry(x=length * step / 400, stamp=START + PERIOD * step) for step in range(401)]
    figure = make_figure(read_run(record(tmp_path / 'kitchen.bag', messages)))
    assert figure.get_suptitle() == f'{tmp_path.name}/kitchen.bag'
    path, distance, *_ = ([text.get_text() for text in axes.get_legend().get_texts()]
                          for axes in figure.axes)
    assert path == ['odometry', 'start', 'end']
    assert ('target, 2' in distance) == drawn


def test_noise_does_not_look_like_motion_and_a_target_is_where_the_robot_turns_to(tmp_path):
    """A robot that turned right by 90 degrees was told to turn to 270."""
    messages = [odometry(x=1e-4 * (step % 2), yaw=-step * math.pi / 200, stamp=START + PERIOD * step)
                for step in range(101)]
    figure = make_figure(read_run(record(tmp_path / 'turn.bag', messages)), heading_target=270.0)
    path, *_, heading = figure.axes
    assert numpy.ptp(path.get_xlim()) >= 0.5 and numpy.ptp(path.get_ylim()) >= 0.5
    assert 'target, -90' in [text.get_text() for text in heading.get_legend().get_texts()]


def test_a_file_without_a_run_is_refused(tmp_path):
    """With status 2 and one line that names it."""
    path = tmp_path / 'broken.bag'
    path.write_bytes(b'no bag at all')
    run = plot(path, '-o', tmp_path / 'no.png')
    assert run.wait() == 2
    assert len(run.stderr.splitlines()) == 1 and str(path) in run.stderr, run.stderr


def test_of_several_odometries_the_user_has_to_choose(tmp_path):
    """All are named, if there is no /odom among them."""
    path = record(tmp_path / 'two.bag', metre(), '/b/odom')
    with rosbag.Bag(str(path), 'a') as bag:
        bag.write('/a/odom', odometry(stamp=START))
    with pytest.raises(BagError, match='no messages on /odom; topics of type nav_msgs/Odometry: '
                                       '/a/odom, /b/odom$'):
        read_run(path)
    assert read_run(path, '/b/odom').odometry.distance[-1] == pytest.approx(1.0)


def test_odometry_without_a_position_is_no_run(tmp_path):
    with pytest.raises(BagError, match='lost.bag'):
        read_run(record(tmp_path / 'lost.bag', [odometry(x=math.nan, stamp=START)] * 3))


def test_a_topic_of_another_type_is_refused(tmp_path):
    """With its name and both types."""
    path = record(tmp_path / 'odd.bag', metre())
    with rosbag.Bag(str(path), 'a') as bag:
        bag.write('/cmd_vel', Float64())
    with pytest.raises(BagError, match='odd.bag has std_msgs/Float64 on /cmd_vel, but must have '):
        read_run(path)
