"""The picture of a recorded run, and the figures that are printed with it."""

import math

import numpy
import pytest
from geometry_msgs.msg import Twist
from odometry_tests.forms import number_after
from odometry_tests.messages import odometry
from odometry_tools.runs.figure import make_figure
from odometry_tools.runs.recorded_run import read_run
from recorded_bags import PERIOD, START, metre, plot, record

PNG = b'\x89PNG'


def test_it_draws_any_bag_with_odometry(tmp_path):
    """A real robot's bag has neither truth nor commands. Jupyter and editors set MPLBACKEND.

    A driver's NaN is no position. The only odometry in a bag is taken by any name.
    The picture lies beside the bag, whose name stands in it: neither as a formula, nor with a warning
    that the font lacks its letters.
    """
    messages = metre()
    messages[0].pose.pose.position.x = math.nan
    messages[40].twist.twist.linear.x = math.nan
    messages[50].pose.pose.orientation.w = math.nan
    messages.append(messages[60])  # late
    bag = record(tmp_path / '$real_{x$ 日本 नम.bag', messages, '/robot_1/odom')
    run = plot(bag, env={'MPLBACKEND': 'nonsense'}, cwd='/')
    assert not run.stderr
    assert number_after('distance', run.stdout) == 0.99
    assert number_after('duration', run.stdout) == 9.9
    assert 'odometry    /robot_1/odom\n' in run.stdout
    assert 'left out    4 messages ignored\n' in run.stdout
    assert bag.with_suffix('.png').read_bytes().startswith(PNG)


@pytest.mark.parametrize('name, error', [
    ('picture', ''), ('own.bag', 'own.bag is the recording'), ('.', "Is a directory: '{}'"),
    ('/dev/full', "No space left on device: '{}'")])
def test_the_picture_is_exactly_the_file_that_is_named(tmp_path, name, error):
    """Also without .png; a name that cannot be one is refused in a line, and not the recording's own."""
    bag, picture = record(tmp_path / 'own.bag', metre()), tmp_path / name
    run = plot(bag, '-o', picture, status=2 if error else 0)
    assert error.format(picture) in run.stderr and len(run.stderr.splitlines()) == bool(error), run.output
    assert bag.read_bytes().startswith(b'#ROSBAG')
    if not error:
        assert picture.read_bytes().startswith(PNG) and f'picture     {picture}\n' in f'{run.stdout}\n'


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


def test_an_empty_twist_is_no_speed_and_an_empty_orientation_no_rotation(tmp_path):
    """Some drivers fill in the position only."""
    messages = metre()
    for message in messages:
        message.twist.twist.linear.x = message.pose.pose.orientation.w = 0.0
    run = read_run(record(tmp_path / 'bare.bag', messages))
    speed = make_figure(run).axes[2]
    assert numpy.isnan(speed.lines[0].get_ydata()).all() and not run.odometry.yaw.any()


@pytest.mark.parametrize('late', [-10.1, 10.1])
def test_a_truth_of_another_time_is_none(tmp_path, late):
    """Its nearest message is no true position."""
    path = record(tmp_path / 'both.bag', metre())
    record(path, [odometry(stamp=START + late + PERIOD * step) for step in range(101)],
           '/base_pose_ground_truth', 'a')
    run = read_run(path)
    assert run.ground_truth is None and 'off truth' not in run.summary()


@pytest.mark.parametrize('begins', [[20.0, 0.0], [0.0]])
def test_a_run_begins_when_a_simulators_time_has_last_restarted(tmp_path, begins):
    """A bag that is recorded by the wall clock, beside commands without a stamp, has its simulator's stamps."""
    messages = [odometry(x=0.01 * step, stamp=begin + PERIOD * step) for begin in begins for step in range(51)]
    path = record(tmp_path / 'reset.bag', messages)
    record(path, messages, '/base_pose_ground_truth', 'a')
    run = read_run(record(path, [Twist()] * len(messages), '/cmd_vel', 'a'))
    for time in run.odometry.time, run.ground_truth.time, run.commands[:, 0]:
        assert time == pytest.approx(PERIOD * numpy.arange(51))
    assert 'distance    0.500 m\nduration    5.0 s\n' in run.summary()
    assert ('left out    51 messages ignored' in run.summary()) == (len(begins) > 1)


def test_a_drive_with_truth_shows_both_distances_and_how_far_they_are_apart(tmp_path):
    """At the same moment: the truth is recorded more often, for longer, and in another frame.

    The wheels slip: the odometry counts 1 m, the robot moves 0.9. The labels of five panels do not overlap.
    """
    path = record(tmp_path / 'both.bag', [
        odometry(x=0.01 * step, yaw=0.01 * step, stamp=START + PERIOD * step) for step in range(101)])
    record(path, [odometry(x=5.0, y=0.00225 * step, yaw=math.pi / 2 + 0.0026 * step, stamp=START + step * PERIOD / 4)
                  for step in range(500)], '/base_pose_ground_truth', 'a')
    run = read_run(path)
    assert 'off truth   0.100 m, 2.29 degrees at the end\n' in f'{run.summary()}\n'
    assert 'off truth   0.050 m, 1.15 degrees' in read_run(path, end=START + 5.0).summary()
    figure = make_figure(run, distance_target=1.0)
    assert figure.get_suptitle() == (
        f'1.000 m by odometry, 0.900 m true, in 10.0 s, target 1 m\n{tmp_path.name}/both.bag')
    legend, = figure.legends
    assert [text.get_text() for text in legend.get_texts()] == ['odometry', 'truth', 'start', 'end', 'target']
    figure.draw_without_rendering()
    _, *panels = figure.axes
    assert [axes.get_ylabel() for axes in panels] == [
        'distance (m)', 'off truth (m)', 'speed (m/s)', 'heading (degrees)', 'turn rate (rad/s)']
    boxes = [axes.yaxis.label.get_window_extent() for axes in panels]
    assert all(above.y0 >= below.y1 for above, below in zip(boxes, boxes[1:])), boxes


def test_a_turn_shows_heading_and_turn_rate_up_to_the_target(tmp_path):
    """A robot that turned right by 90 degrees was told to turn to 270: its panels hold no path."""
    messages = [odometry(x=1e-4 * (step % 2), yaw=-step * math.pi / 200, stamp=START + PERIOD * step)
                for step in range(101)]
    figure = make_figure(read_run(record(tmp_path / 'turn.bag', messages)), heading_target=270.0)
    assert figure.get_suptitle().startswith('turned -90.0 degrees in 10.0 s, target 270 degrees\n')
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert labels == ['heading (degrees)', 'turn rate (rad/s)']
    drawn, target = figure.axes[0].lines
    assert target.get_ydata()[0] == pytest.approx(drawn.get_ydata()[-1]) == -90
