"""The picture of a recorded run, and the figures that are printed with it."""

import math

import pytest
import rosbag
import rospy
from geometry_msgs.msg import TwistStamped
from odometry_launch.run_plot import BagError, make_figure, read_run
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


def record(path, messages):
    """Write a bag as a real robot's: without commands or the robot's true position."""
    with rosbag.Bag(str(path), 'w') as bag:
        for number, message in enumerate(messages):
            bag.write('/odom', message, rospy.Time.from_sec(START + PERIOD * number))
    return path


def plot(*arguments, **options):
    """Run plot_run."""
    return Process('rosrun', 'sim_turtlebot', 'plot_run.py', *arguments, **options)


@pytest.mark.parametrize('backend', ['', 'module://matplotlib_inline.backend_inline', 'nonsense'])
def test_it_draws_any_bag_with_odometry(tmp_path, backend):
    """A real robot's bag has neither truth nor commands. Jupyter and editors set MPLBACKEND."""
    picture = tmp_path / 'real.png'
    run = plot(record(tmp_path / 'real.bag', metre()), '-o', picture, env={'MPLBACKEND': backend})
    assert run.wait(30.0) == 0, run.output
    assert number_after('distance', run.stdout) == 1.0
    assert number_after('duration', run.stdout) == 10.0
    assert number_after('mean speed', run.stdout) == 0.1
    assert number_after('top speed', run.stdout) == 0.1
    assert picture.read_bytes().startswith(PNG)


def test_what_is_not_finite_is_left_out(tmp_path):
    """A driver's NaN is no position, and no top speed."""
    messages = metre()
    messages[0].pose.pose.position.x = math.nan
    messages[30].pose.pose.position.y = math.inf
    messages[40].twist.twist.linear.x = math.nan
    messages[50].pose.pose.orientation.w = math.nan
    run = plot(record(tmp_path / 'odd.bag', messages), '-o', tmp_path / 'odd.png')
    assert run.wait(30.0) == 0, run.output
    assert number_after('distance', run.stdout) == 0.99
    assert number_after('duration', run.stdout) == 9.9
    assert number_after('top speed', run.stdout) == 0.1


def test_a_jump_is_no_distance(tmp_path):
    """The robot is carried 50 m away and back: the detector's sum counts neither."""
    messages = metre()
    for message in messages[40:60]:
        message.pose.pose.position.y = 50.0
    run = read_run(record(tmp_path / 'carried.bag', messages))
    assert run.odometry.distance[-1] == pytest.approx(0.98)
    assert run.odometry.distance.max() == run.odometry.distance[-1]


def test_what_comes_after_the_end_of_a_run_is_left_out(tmp_path):
    """A demo's picture ends with the arrival, its recording a little later."""
    run = read_run(record(tmp_path / 'run.bag', metre()), end=START + 5.0)
    assert run.odometry.time[-1] == pytest.approx(5.0)
    assert run.odometry.distance[-1] == pytest.approx(0.5)


@pytest.mark.parametrize('length, drawn', [(0.5, False), (1.9, True), (2.005, True), (100, False)])
def test_the_two_metre_line_is_there_for_a_run_of_about_two_metres(tmp_path, length, drawn):
    """On a long run it would lie on the axis."""
    messages = [odometry(x=length * step / 400, stamp=START + PERIOD * step) for step in range(401)]
    figure = make_figure(read_run(record(tmp_path / 'run.bag', messages)))
    assert ('two metres' in labels(figure, 'moved distance')) == drawn


def test_the_picture_names_the_bag_and_marks_start_and_end(tmp_path):
    """So that pictures can be told apart."""
    bag = record(tmp_path / 'kitchen.bag', metre())
    figure = make_figure(read_run(bag))
    assert figure.get_suptitle() == f'{tmp_path.name}/kitchen.bag'
    assert labels(figure, 'path from above') == ['odometry', 'start', 'end']
    end = figure.axes[0].get_lines()[-1]
    assert (end.get_xdata()[0], end.get_ydata()[0]) == pytest.approx((1.0, 0.0))


def labels(figure, title):
    """Return what the legend of the diagram with that title explains."""
    axes, = (axes for axes in figure.axes if axes.get_title() == title)
    return [text.get_text() for text in axes.get_legend().get_texts()]


@pytest.mark.parametrize('content', [None, b'', b'no bag at all'])
def test_what_is_no_bag_is_refused(tmp_path, content):
    """One line that names the file."""
    path = tmp_path / 'broken.bag'
    if content is not None:
        path.write_bytes(content)
    assert_refused(path)


@pytest.mark.parametrize('messages', [[], [odometry(x=math.nan, stamp=START)] * 3])
def test_a_bag_without_a_single_position_is_refused(tmp_path, messages):
    """One line that names the file."""
    assert_refused(record(tmp_path / 'empty.bag', messages))


@pytest.mark.parametrize('topic, message, kind', [
    ('/odom', Float64(), 'std_msgs/Float64'),
    ('/base_pose_ground_truth', Float64(), 'std_msgs/Float64'),
    ('/cmd_vel', TwistStamped(), 'geometry_msgs/TwistStamped')])
def test_a_topic_of_another_type_is_refused(tmp_path, topic, message, kind):
    """With its name and both types."""
    path = record(tmp_path / 'odd.bag', [] if topic == '/odom' else metre())
    with rosbag.Bag(str(path), 'a') as bag:
        bag.write(topic, message)
    with pytest.raises(BagError, match=f'odd.bag has {kind} on {topic}, but must have '):
        read_run(path)


def assert_refused(path):
    """Check that plot_run ends with one line about the bag and status 2."""
    run = plot(path, '-o', path.with_suffix('.png'))
    assert run.wait(30.0) == 2
    assert len(run.stderr.splitlines()) == 1 and str(path) in run.stderr, run.stderr
