"""What a replay makes of a recording, and what it does not accept."""

import pytest
import rosbag
import rospy
from odometry_common.parameters import StartError
from odometry_launch.graph import DemoError
from odometry_sweep.recorded import figures_of
from odometry_sweep.replay import _compare, replay
from odometry_tests.messages import odometry
from std_msgs.msg import Float64

PERIOD = 0.05  # s
SETTLED = [0.0, 0.0, 0.01, 0.06, 0.11, 0.11]
PARAMETERS = {'distance': 0.1}


def record(path, positions, moved, repeated=2):
    """Write the bag of a robot at these places (m); the first odometry is repeated."""
    messages = []
    for number, x in enumerate(positions):
        message = odometry(x=x, stamp=PERIOD * number)
        message.header.seq = number
        messages += [message] * (repeated if number == 0 else 1)
    with rosbag.Bag(str(path), 'w') as bag:
        for number, message in enumerate(messages):
            for topic in ('/odom', '/base_pose_ground_truth'):
                bag.write(topic, message, rospy.Time(1, number))
        for number, distance in enumerate(moved):
            bag.write('/moved_distance', Float64(distance), rospy.Time(1, number))
    return path


def sums(positions):
    """Return what the detector says of them."""
    total, distances = 0.0, [0.0]
    for before, after in zip(positions, positions[1:]):
        total += abs(after - before)
        distances.append(total)
    return distances


@pytest.mark.parametrize('repeated, zeros', [(1, 0), (3, 2), (3, 0)])
def test_the_figures_are_those_of_the_messages(tmp_path, repeated, zeros):
    """However often the first odometry is heard, by the recording and by the detector."""
    bag = record(tmp_path / 'run.bag', SETTLED, [0.0] * zeros + sums(SETTLED), repeated)
    figures = figures_of(bag, 'move', PARAMETERS)
    assert (figures['moved'], figures['true_distance']) == (pytest.approx(0.11), 0.11)
    assert (figures['time'], figures['ended']) == (PERIOD * 5, 'arrived')


def test_a_detector_that_counts_something_else_is_noticed(tmp_path):
    """Even in the last digit."""
    moved = sums(SETTLED)
    moved[3] += 1e-16
    with pytest.raises(DemoError, match='has counted something else'):
        figures_of(record(tmp_path / 'run.bag', SETTLED, moved), 'move', PARAMETERS)


def test_a_recording_with_a_gap_is_noticed(tmp_path):
    """Its figures would be another run's."""
    path = record(tmp_path / 'run.bag', [], [])
    with pytest.raises(DemoError, match='the recording has gaps'):
        figures_of(path, 'move', PARAMETERS)


def test_a_recording_that_is_cut_off_is_one_line(tmp_path):
    """The disk was full."""
    path = tmp_path / 'run.bag'
    path.write_bytes(b'#ROSBAG V2.0\n')
    with pytest.raises(DemoError, match='run.bag cannot be read'):
        figures_of(path, 'move', PARAMETERS)


@pytest.mark.parametrize('rows, number, line', [
    ('run,seed,time\n1,0,2.5\n', 2, 'run 2 is not among the 1 in '),
    ('run,seed\n1,0\n', 1, 'run 1 in .*runs.csv is incomplete'),
    ('run,seed,time\n1,0,x\n', 1, 'is incomplete'), (None, 1, 'runs.csv cannot be read')])
def test_a_run_that_is_not_there_is_one_line(tmp_path, rows, number, line):
    """Before anything is started."""
    (tmp_path / 'campaign.yaml').write_text('tutorial: move\n')
    if rows:
        (tmp_path / 'runs.csv').write_text(rows)
    with pytest.raises(StartError, match=line):
        replay(tmp_path, number)


def test_a_figure_that_differs_in_its_last_digit_is_named(capsys):
    """Both are shown."""
    row = {'moved': '2.0040552948896644', 'ended': 'arrived'}
    assert _compare(['moved', 'ended'], row, {'moved': 2.004055294889664, 'ended': 'arrived'}) == [
        'moved']
    assert '2.0040552948896644      2.004055294889664\n' in capsys.readouterr().out
