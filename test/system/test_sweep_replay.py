"""A run of a sweep is what the nodes do in lockstep, to the last bit."""

import os
import re
from pathlib import Path

import pytest
import rosbag
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT

TIMEOUT = 90.0  # s
RUN = '3'
NOISE = ['odometry_source=encoder', 'wheel_slip=0.01', 'wheel_noise=0.01']
MOVE = ['move', 'distance=0.5', 'speed=0.2,-0.3', 'yaw=1', *NOISE]
ROTATE = ['rotate', 'target=-100', 'kp=1,1.5', 'rate=10', *NOISE]


def sweep(*arguments):
    """Run ./ws sweep to its end and return its process."""
    process = Process(ROOT / 'ws', 'sweep', *arguments, cwd=ROOT)
    process.wait(TIMEOUT)
    return process


@pytest.mark.parametrize('tutorial, parameters, topics', [
    (*MOVE[:1], MOVE[1:], {'/odom', '/base_pose_ground_truth', '/moved_distance', '/cmd_vel'}),
    (*ROTATE[:1], ROTATE[1:], {'/odom', '/base_pose_ground_truth', '/cmd_vel'})],
    ids=['move', 'rotate'])
def test_a_row_and_its_replay_are_equal(tutorial, parameters, topics):
    """With noise from its own seed; the bag and the picture are those of the nodes."""
    swept = sweep(tutorial, '--seeds', '2', *(
        word for parameter in parameters for word in ('--set', parameter)))
    assert swept.wait() == 0, swept.output
    folder = Path(os.environ['ODOMETRY_RUNS'], re.search(r'sweep-[-\w]+', swept.stdout)[0])
    run = sweep('--replay', str(folder), RUN)
    assert run.wait() == 0, run.output
    assert run.stdout.splitlines()[-1] == 'the same, to the last bit'
    picture = ROOT / re.search(r'picture +(.*)', run.stdout)[1]
    assert picture.exists()
    with rosbag.Bag(str(picture.with_name('run.bag'))) as bag:
        assert set(bag.get_type_and_topic_info().topics) == topics


@pytest.mark.parametrize('arguments, line', [
    (['/no/such/folder', '1'], 'sweep: /no/such/folder/campaign.yaml cannot be read'),
    (['.', 'last'], "./ws sweep: error: argument --replay: 'last' is not a whole number")])
def test_what_is_not_there_gets_one_line(arguments, line):
    """And exit status 2; no master is started."""
    run = sweep('--replay', *arguments)
    assert run.wait() == 2 and run.stdout == ''
    assert run.stderr.splitlines()[-1].startswith(line), run.stderr
