"""What the check says of a node that published nothing: what the graph, the output and the exit status show."""

import math
import signal

import pytest
from kinematic_robot import PLAIN, verdict_on
from learners import BAD_CALLBACK, ERROR, MAIN_ERROR
from odometry_tools.check.check_session import Pace
from odometry_tools.check.processes import has_node_logged
from odometry_tools.check.run import Command, Pose, Run

HEARS = {'/odom': 'nav_msgs/Odometry'}
TWIST = 'geometry_msgs/Twist'
ZERO = [Command(0.0, 0.0, 0.0, (), 'cmd_vel')]
DIED = '[mine-2] process has died [pid 17, exit code 1, cmd /x].\n'


def verdict_with(**facts):
    """Return the Verdict on a Run of which these facts are known, and that is otherwise empty."""
    run = Run(PLAIN, Pace(), None)
    run.odometry.append(Pose(0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    run.nodes = {'/mine'}
    run.subscribes, run.publishes = HEARS, {'/cmd_vel': TWIST}
    vars(run).update(facts)
    return verdict_on(run)


@pytest.mark.parametrize('facts, expected', [
    ({'nodes': (), 'status': 0}, 'no_node main'),
    ({'nodes': (), 'has_begun': True, 'status': 0}, 'silent ended'),
    ({'nodes': (), 'status': 1, 'output': ERROR}, 'crash error'),
    ({'nodes': (), 'has_read_keyboard': True}, 'no_node keyboard'),
    ({'nodes': (), 'status': 0, 'output': 'ERROR: cannot launch node of type [a/b.py]: \n'}, 'no_node not_there'),
    ({'status': 3, 'output': f'{ERROR}giving up\n'}, 'crash last_words'),
    ({'status': 0, 'output': f'{ERROR}no file\n'}, 'silent ended'),
    ({'output': MAIN_ERROR + DIED}, 'crash error'),
    ({'status': 1, 'output': f'{MAIN_ERROR}stopping\n'}, 'crash error'),
    ({'status': 1, 'output': f'{ERROR}giving up\n'}, 'crash last_words'),
    ({'output': DIED.replace('mine', 'rviz')}, 'silent'),
    ({'output': BAD_CALLBACK}, 'silent callback'),
    ({'output': BAD_CALLBACK, 'publishes': {'/distance': 'std_msgs/Float32'}}, 'silent output'),
    ({'output': f'Exception in thread Thread-6:\n{ERROR}'}, 'silent printed'),
    ({'status': 0, 'commands': ZERO}, 'all_zero ended'),
    ({'refuses': True}, 'silent queue_size'),
    ({'publishes': {'/cmd_vel': 'geometry_msgs/TwistStamped'}}, 'silent output'),
    ({'publishes': {'/cmd_vel_mux/input/navi': TWIST}}, 'silent'),
    ({'publishes': {'/rosout': ''}}, 'silent no_output'),
    ({'subscribes': {'/odometry': ''}, 'publishes': {'/status': 'std_msgs/String'}}, 'silent input'),
    ({'subscribes': {'/tf': 'tf/tfMessage'}}, 'silent'),
    ({'commands': [ZERO[0]._replace(linear=math.nan)]}, 'not_finite'),
    ({'subscribes': {'/moved_distance/reset': 'std_msgs/Empty', **HEARS}}, 'silent')])
def test_a_cause_has_a_witness(facts, expected):
    verdict = verdict_with(**facts)
    assert f'{verdict.rule} {verdict.hint}'.strip() == expected


@pytest.mark.parametrize('facts, words', [
    ({'status': -signal.SIGSEGV}, 'by a signal (Segmentation fault)'),
    ({}, 'We do not know why: print a line before you publish, to see whether it is reached; what you publish before'),
    ({'subscribes': {'/odom': 'geometry_msgs/PoseStamped'}}, 'You subscribe to /odom as geometry_msgs/PoseStamped')])
def test_the_sentence_has_what_was_seen(facts, words):
    assert words in verdict_with(**facts).sentence


def test_the_log_of_rospy_shows_that_a_node_has_begun(tmp_path):
    """Also of one that has ended before anybody looked; roslaunch's logs do not."""
    (tmp_path / 'run').mkdir()
    for name in 'roslaunch-host-1.log', 'mine-1-stdout.log', 'mine-1.log':
        (tmp_path / 'run' / name).touch()
        assert has_node_logged(tmp_path) == (name == 'mine-1.log')
