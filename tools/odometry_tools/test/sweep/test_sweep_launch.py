"""A sweep of somebody's launch file: rows, what is refused, and nodes that end or crash."""

import contextlib
import os
import re
import shutil
import sys
import tempfile
from unittest import mock

import pytest
from guest_package import FILES, FOLLOW
from odometry_common.parameters import StartError
from odometry_tests.linux import marked
from odometry_tests.processes import Process, run
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until
from odometry_tools.runs.output import RunError
from odometry_tools.sweep import session_process
from odometry_tools.sweep.campaign import Campaign
from odometry_tools.sweep.subjects import Launched
from sweeps import SCRIPT, TIMEOUT, folder_of, rows_in, sweep_by_script


@pytest.fixture(autouse=True)
def packages(tmp_path, monkeypatch):
    """Make a package, and the example under another name: it may be in the workspace, too."""
    folder = tmp_path / 'guest'
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text.replace('{python}', sys.executable))
        (folder / name).chmod(0o755)
    (folder / 'plain.py').touch()
    example = shutil.copytree(ROOT / 'docs/example', tmp_path / 'example')
    for file in example / 'package.xml', example / 'launch/one_metre.launch':
        file.write_text(re.sub('(<name>|pkg=")one_metre', r'\1example', file.read_text()))
    monkeypatch.setenv('ROS_PACKAGE_PATH', f'{folder}:{example}:{os.environ["ROS_PACKAGE_PATH"]}')


def test_the_example_gives_the_same_bytes_each_time():
    """The robot's parameters reach the robot, and the others the node."""
    arguments = ['example', 'one_metre.launch', '--until', '4', '--seeds', '2', '--set', 'speed=0.5',
                 '--set', 'odometry_source=encoder', '--set', 'wheel_noise=0.01']
    printed = sweep_by_script(*arguments).stdout
    first = folder_of(printed)
    assert re.search(r'^from_start \(m\) .*\nall runs +1\.0', printed, re.MULTILINE), printed
    rows = rows_in(first)
    assert [row['ended'] for row in rows] == ['until', 'until']
    assert all(float(row['time']) < 4.0 and row['commands'] == '40' for row in rows), rows
    assert len({row['odometry_error'] for row in rows} - {'0.0'}) == 2, 'no noise, or always the same'
    again = sweep_by_script('--campaign', first / 'campaign.yaml', '--jobs', '1')
    assert (folder_of(again.stdout) / 'runs.csv').read_bytes() == (first / 'runs.csv').read_bytes()


def swept(*words):
    """Sweep a launch file of the package; return what was printed, and how each run ended."""
    printed = sweep_by_script('guest', *words).stdout
    return printed, [row['ended'] for row in rows_in(folder_of(printed))]


@pytest.mark.parametrize('words, ends', [
    (['nodes.launch', '--until', '2', '--set', 'end=crash'], ['crashed']),
    pytest.param(['nodes.launch', '--until', '2', '--set', 'end=done,crash,busy,never'],
                 ['arrived', 'crashed', 'not awaited', 'late'], marks=pytest.mark.nightly),
    (['naps.launch', '--until', '4', '--set', 'nap=sleep,select,event'], 3 * ['not awaited']),
    (['late.launch', '--until', '1'], ['not awaited']),
    (['again.launch', '--until', '1'], ['not awaited']),
    (['tidy.launch', '--until', '0.1', '--seeds', '2', '--jobs', '1'], ['until', 'until'])],
    ids=['crash', 'each end', 'sleeps by wall time', 'begins after simulated time', 'respawns',
         'finds no parameter of the run before'])
def test_how_a_run_ended_is_a_column(words, ends):
    """A crash ends neither the campaign nor the run."""
    printed, found = swept(*words)
    assert found == ends
    assert printed.count('not arrived') == sum(end not in ('arrived', 'until') for end in ends), printed
    if ends == ['crashed']:
        assert 'not arrived     1 of 1, with all runs; the first is run 1: node has ended with status 1; last error printed: ' in printed, printed


def test_the_end_of_a_run_may_have_an_exponent():
    """In a file; YAML reads 1e1 as a string."""
    assert Launched(['guest', 'nodes.launch'], '1e1').checked({}).until == 10.0


def test_a_sweep_runs_where_no_home_can_be_written(monkeypatch):
    monkeypatch.setenv('HOME', '/dev/null')
    _, ends = swept('tidy.launch', '--until', '0.1')
    assert ends == ['until']


def test_a_node_that_crashes_at_some_seeds_does_so_again_to_the_byte():
    printed, ends = swept('nodes.launch', '--until', '2', '--seeds', '4', '--set', 'end=chance', '--set',
                          'odometry_source=encoder', '--set', 'wheel_noise=0.05')
    assert {*ends} == {'arrived', 'crashed'}, ends
    assert f'not arrived     {ends.count("crashed")} of 4, with all runs' in printed, printed
    again = sweep_by_script('--replay', folder_of(printed), ends.index('crashed') + 1)
    assert again.stdout.splitlines()[-1] == 'the same, to the last bit'
    assert 'sweep: node has ended with status 1; last error printed: ValueError: on purpose' in again.stderr


@pytest.mark.parametrize('service, line', [
    ('unpause_physics', 'sweep: somebody has called unpause_physics, but '),
    ('reset_simulation', 'sweep: somebody has called reset_simulation after 1')])
def test_a_node_that_changes_how_time_goes_on_is_named(service, line):
    printed = sweep_by_script('guest', 'calls.launch', '--until', '3', '--set', f'service={service}', status=1)
    assert printed.stderr.startswith(line) and len(printed.stderr.splitlines()) == 1, printed.stderr


def test_what_a_node_prints_before_it_is_there_is_shown():
    with Process(sys.executable, '-c', FOLLOW, 'again.launch') as process:
        process.wait_for_output('again\nagain\n')  # what it printed first is in memory


def test_a_node_that_cannot_be_started_is_not_waited_for():
    followed = run(sys.executable, '-c', FOLLOW, 'plain.launch', 'watched', status=1)
    assert followed.stderr == '-c: plain has ended before it started'


def test_ctrl_c_ends_runs_that_would_go_on_for_long(mark):
    """With all that they have started, one line, and no file."""
    with tempfile.TemporaryDirectory() as temporary, \
            Process(*SCRIPT, 'guest', 'nodes.launch', '--until', '1e5', '--set', 'end=never', '--seeds', '3',
                    env={'TMPDIR': temporary}) as sweeping:
        wait_until(lambda: 'node.py' in str([one.info for one in marked(mark)]), TIMEOUT, 'a node')
        assert sweeping.end(timeout=TIMEOUT) == 130, sweeping.output
        wait_until(lambda: not os.listdir(temporary), TIMEOUT, 'no file')
    assert re.fullmatch(r'sweep: interrupted after 0 of 3 runs, which are in \S+', sweeping.stderr), sweeping.stderr
    wait_until(lambda: not marked(mark), TIMEOUT, lambda: f'an end of {marked(mark)}')


def test_a_session_that_breaks_is_replaced_once(monkeypatch):
    broken, fresh = mock.Mock(), mock.Mock()
    broken.run.side_effect = RunError('broken')
    fresh.run.side_effect = [1, RunError('broken'), RunError('broken again')]
    monkeypatch.setattr(session_process, 'SessionProcess', mock.Mock(return_value=fresh))
    monkeypatch.setattr(session_process, 'kept', mock.Mock(process=broken))
    assert session_process.run_in_session(None, {}) == 1
    with pytest.raises(RunError, match='broken again'):
        session_process.run_in_session(None, {})


def test_a_session_whose_run_fails_after_the_sweep_has_ended_says_nothing(monkeypatch):
    def fail(connection):
        sweep_end.close()
        raise RunError('sim_turtlebot has ended')

    monkeypatch.setenv('ROS_LOG_DIR', '')
    monkeypatch.setattr(session_process, '_answer', fail)
    sweep_end, session_end = session_process.CONTEXT.Pipe()
    with contextlib.closing(session_end):
        session_process._serve(session_end)  # an exception would be printed


def test_a_program_that_is_no_node_is_not_waited_for_and_an_argument_may_have_a_parameters_name():
    printed = sweep_by_script('guest', 'helper.launch', '--until', '2', '--set', 'launch:x=done', '--set', 'x=1', timeout=60.0).stdout
    row, = rows_in(folder_of(printed))
    assert (row['ended'], row['x'], row['launch:x']) == ('until', '1', 'done')


def test_a_sweep_in_which_no_command_reaches_the_robot_says_so():
    printed, _ = swept('early.launch', '--until', '1')
    assert 'no commands     reached the robot, with all runs: ' in printed, printed


@pytest.mark.parametrize('launched, values, line', [
    ('guest plain.launch', {}, 'plain.launch: node plain, guest/plain.py: Cannot locate node of type [plain.py] in package [guest]'),
    ('guest elsewhere.launch', {}, 'elsewhere.launch: node node, guest/node.py, has a ROS_MASTER_URI of its own'),
    ('guest nodes.launch', {'ends': [1]}, 'parameter ends cannot be set in a sweep of nodes.launch: did you mean end?'),
    ('guest nodes.launch', {'lockstep': [False]}, 'parameter lockstep cannot be set in a sweep of'),
    ('guest nodes.launch', {'scan_rate': [5], 'clock_rate': [10], 'odom_rate': [20]},
     'parameter ~clock_rate is 10, but must be a number 0 or from ~odom_rate (20) to 1000 Hz'),
    ('guest typed.launch', {'type': ['node.py'], 'time': [2]}, 'parameter time cannot be set in a sweep of typed'),
    ('guest nodes.launch', {'end': ['done', 'a:=b']}, "end is 'a:=b', but roslaunch passes no value that is"),
    ('guest nodes.launch', {'end': ['']}, "end is '', but"),
    ('guest eval.launch', {}, 'eval.launch: division by zero'),
    ('guest remote.launch', {}, 'node node, guest/node.py, is for the machine other, where'),
    ('guest robot.launch', {}, 'robot.launch: a node has the name of the robot, sim_turtlebot: give it another'),
    ('guest none.launch', {}, 'none.launch starts no node'),
    ('guest other.launch', {}, 'other.launch] is neither a launch file in package'),
    (f'{ROOT}/docs/example/launch/one_metre.launch x', {}, 'there is no package /')])
def test_a_launch_file_that_cannot_be_swept_is_one_line(launched, values, line):
    with pytest.raises(StartError) as refusal:
        Campaign(Launched(launched.rsplit(' ', 1), 1.0), 1, values, {}).checked()
    assert line in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
