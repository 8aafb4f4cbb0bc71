"""A run of a sweep is what the nodes do in lockstep, to the last bit."""

import re
from contextlib import nullcontext

import pytest
import rosbag
import rospy
from odometry_common.parameters import StartError
from odometry_tests.messages import odometry
from odometry_tests.scripts import ROOT
from odometry_tools.runs.output import RunError
from odometry_tools.sweep import lockstep
from odometry_tools.sweep.lockstep import replay, tutorial_metrics
from std_msgs.msg import Float64
from sweeps import folder_of, sweep

NOISE = ['odometry_source=encoder', 'wheel_slip=0.01', 'wheel_noise=0.01']
PLACES = [0.0, 0.01, 0.06, 0.11, 0.11]  # m
ROBOT = ['/odom', '/base_pose_ground_truth']


@pytest.fixture
def recorded(tmp_path):
    def record(moved=0.11, missing=None):
        with rosbag.Bag(str(tmp_path / 'run.bag'), 'w') as bag:
            bag.write('/moved_distance', Float64(moved), rospy.Time(1))
            for number, x in enumerate(PLACES):
                message = odometry(x=x, stamp=0.05 * number)
                message.header.seq = number
                for topic in ROBOT if number != missing else ():
                    bag.write(topic, message, rospy.Time(1, number))
        return tmp_path / 'run.bag'
    return record


@pytest.mark.parametrize('tutorial, parameters, topics', [
    ('move', ['distance=0.5', 'speed=0.2,-0.3', 'yaw=1'], ['/moved_distance', '/cmd_vel']),
    pytest.param('rotate', ['target=-100', 'kp=1,1.5', 'rate=7'], ['/cmd_vel'],
                 marks=pytest.mark.nightly)], ids=['move', 'rotate'])
def test_a_row_and_its_replay_are_equal(tutorial, parameters, topics):
    """With noise from its own seed; the bag and the picture are those of the nodes."""
    options = [word for value in [*parameters, *NOISE] for word in ('--set', value)]
    swept = sweep(tutorial, '--seeds', '2', *options)
    run = sweep('--replay', folder_of(swept.stdout), 3)
    assert run.stdout.splitlines()[-1] == 'the same, to the last bit'
    picture = ROOT / re.search(r'picture +(.*)', run.stdout)[1]
    assert picture.exists()
    with rosbag.Bag(str(picture.with_name('run.bag'))) as bag:
        assert {*bag.get_type_and_topic_info().topics} == {*ROBOT, *topics}


def test_a_metric_that_differs_in_its_last_digit_is_named(tmp_path, monkeypatch, recorded, capsys):
    bag = recorded()
    row = tutorial_metrics('move', {'distance': 0.1}, bag)
    assert (row['true_distance'], row['time'], row['ended']) == (0.11, 0.2, 'arrived')
    (tmp_path / 'campaign.yaml').write_text('tutorial: move\nset: {distance: 0.1}\n')
    row.update(run=1, moved=0.11000000000000001)
    (tmp_path / 'runs.csv').write_text(f'{",".join(row)}\n{",".join(map(str, row.values()))}\n')
    monkeypatch.setattr(lockstep, 'Session', nullcontext)
    monkeypatch.setattr(lockstep, 'run_nodes', lambda *_: ({**row, 'moved': 0.11}, bag, {}))
    with pytest.raises(RunError, match='not the same: moved$'):
        replay(tmp_path, '1')
    assert 'moved           0.11000000000000001     0.11\n' in capsys.readouterr().out


@pytest.mark.parametrize('recording, line', [
    ({'moved': 0.11000000000000001}, 'published another distance'), ({'missing': 2}, 'has gaps')])
def test_a_recording_that_is_not_that_of_the_run_is_refused(recorded, recording, line):
    with pytest.raises(RunError, match=line):
        tutorial_metrics('move', {'distance': 0.1}, recorded(**recording))


@pytest.mark.parametrize('number, rows', [
    ('2', 'run,seed,time\n1,0,2.5\n'), ('1', 'run,seed\n1,0\n'), ('last', 'run,time\nlast,2.5\n'), ('1', None)])
def test_a_run_that_is_not_there_is_one_line(tmp_path, number, rows):
    (tmp_path / 'campaign.yaml').write_text('tutorial: move\n')
    if rows:
        (tmp_path / 'runs.csv').write_text(rows)
    with pytest.raises(StartError, match=f'runs.csv has no run {number}'):
        replay(tmp_path, number)
