"""A sweep of somebody's launch file: rows, what is refused, and nodes that end or crash."""

import contextlib
import os
import re
import shutil
import signal
import sys

import pytest
from guest_package import FILES, FOLLOW
from odometry_common.parameters import StartError
from odometry_tests.linux import marked
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until
from odometry_tools.runs.output import RunError
from odometry_tools.sweep import session_process
from odometry_tools.sweep.campaign import Campaign
from odometry_tools.sweep.subjects import Launched
from sweeps import SCRIPT, TIMEOUT, folder_of, rows_in, sweep

EXAMPLE = ROOT / 'docs' / 'example'


@pytest.fixture(autouse=True)
def packages(tmp_path, monkeypatch):
    """Make a package, and the example under another name: it may be in the workspace, too."""
    folder = tmp_path / 'guest'
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text.replace('{python}', sys.executable))
        (folder / name).chmod(0o755)
    (folder / 'plain.py').touch()
    example = shutil.copytree(EXAMPLE, tmp_path / 'example')
    for file in (example / 'package.xml', example / 'launch' / 'one_metre.launch'):
        file.write_text(re.sub('(<name>|pkg=")one_metre', r'\1example', file.read_text()))
    monkeypatch.setenv('ROS_PACKAGE_PATH', f'{folder}:{example}:{os.environ["ROS_PACKAGE_PATH"]}')


def test_the_example_gives_the_same_bytes_each_time():
    """The robot's parameters reach the robot, and the others the node."""
    arguments = ['example', 'one_metre.launch', '--until', '4', '--seeds', '2', '--set', 'speed=0.5',
                 '--set', 'odometry_source=encoder', '--set', 'wheel_noise=0.01']
    run = sweep(*arguments, command=SCRIPT)  # ./ws knows only its own packages
    first, printed = folder_of(run.stdout), run.stdout
    assert re.search(r'^from_start \(m\) .*\nall runs +1\.0', printed, re.MULTILINE), printed
    rows = rows_in(first)
    assert [row['ended'] for row in rows] == ['until', 'until']
    assert all(float(row['time']) < 4.0 and row['commands'] == '40' for row in rows), rows
    assert len({row['odometry_error'] for row in rows} - {'0.0'}) == 2, 'no noise, or always the same'
    run = sweep('--campaign', str(first / 'campaign.yaml'), '--jobs', '1', command=SCRIPT)
    assert (folder_of(run.stdout) / 'runs.csv').read_bytes() == (first / 'runs.csv').read_bytes()


@pytest.mark.parametrize('ends', [['crash'], pytest.param(
    ['done', 'crash', 'busy', 'never'], marks=pytest.mark.nightly)], ids=len)
def test_how_a_run_ended_is_a_column(ends):
    """A crash ends neither the campaign nor the run."""
    printed = sweep('guest', 'nodes.launch', '--until', '2', '--set', f'end={",".join(ends)}',
                    command=SCRIPT).stdout
    expected = {'done': 'arrived', 'crash': 'crashed', 'busy': 'not awaited', 'never': 'late'}
    assert [row['ended'] for row in rows_in(folder_of(printed))] == [expected[end] for end in ends]
    assert printed.count('not arrived') == len({*ends} - {'done'}), printed
    if ends == ['crash']:
        assert 'not arrived     1 of 1, with all runs; the first is run 1\n' in printed, printed


def test_a_short_run_of_a_node_that_sleeps_by_wall_time_says_so():
    printed = sweep('guest', 'naps.launch', '--until', '4', '--set', 'nap=sleep,select,event', command=SCRIPT).stdout
    assert [row['ended'] for row in rows_in(folder_of(printed))] == 3 * ['not awaited'], printed


def test_a_node_that_begins_after_simulated_time_has_begun_says_so():
    printed = sweep('guest', 'late.launch', '--until', '1', command=SCRIPT).stdout
    assert [row['ended'] for row in rows_in(folder_of(printed))] == ['not awaited'], printed


def test_a_node_that_crashes_at_some_seeds_does_so_again_to_the_byte():
    printed = sweep('guest', 'nodes.launch', '--until', '2', '--seeds', '4', '--set', 'end=chance', '--set',
                    'odometry_source=encoder', '--set', 'wheel_noise=0.05', command=SCRIPT).stdout
    ends = [row['ended'] for row in rows_in(folder_of(printed))]
    assert {*ends} == {'arrived', 'crashed'}, ends
    assert f'not arrived     {ends.count("crashed")} of 4, with all runs' in printed, printed
    again = sweep('--replay', str(folder_of(printed)), str(ends.index('crashed') + 1), command=SCRIPT)
    assert again.stdout.splitlines()[-1] == 'the same, to the last bit'
    assert again.stderr == 'sweep: node has ended with status 1; last error printed: ValueError: on purpose'


def test_a_run_leaves_no_parameter_to_the_next_in_its_session():
    printed = sweep('guest', 'tidy.launch', '--until', '0.1', '--seeds', '2', '--jobs', '1', command=SCRIPT).stdout
    assert [row['ended'] for row in rows_in(folder_of(printed))] == ['until', 'until'], printed


@pytest.mark.parametrize('service, line', [
    ('unpause_physics', 'sweep: somebody has called unpause_physics, but '),
    ('reset_simulation', 'sweep: somebody has called reset_simulation after 1')])
def test_a_node_that_changes_how_time_goes_on_is_named(service, line):
    printed = sweep('guest', 'calls.launch', '--until', '3', '--set', f'service={service}', status=1, command=SCRIPT)
    assert printed.stderr.startswith(line) and len(printed.stderr.splitlines()) == 1, printed.stderr


def test_a_node_that_respawns_is_started_again_and_the_run_says_so():
    with Process(sys.executable, '-c', FOLLOW, 'again.launch') as process:
        process.wait_for_output('again\nagain\n')  # what it printed first is in memory
    printed = sweep('guest', 'again.launch', '--until', '1', command=SCRIPT).stdout
    assert [row['ended'] for row in rows_in(folder_of(printed))] == ['not awaited'], printed


def test_a_node_that_cannot_be_started_is_not_waited_for():
    with Process(sys.executable, '-c', FOLLOW, 'plain.launch', 'plain') as process:
        assert process.wait() == 1, process.output
    assert process.stderr == 'follow: plain has ended before it started'


def test_ctrl_c_ends_runs_that_would_go_on_for_long(mark):
    """With all that they have started, and one line."""
    with Process(*SCRIPT, 'guest', 'nodes.launch', '--until', '1e5', '--set', 'end=never', '--seeds', '3') as run:
        wait_until(lambda: 'node.py' in str([one.info for one in marked(mark)]), TIMEOUT, 'a node')
        run.send(signal.SIGINT)
        assert run.wait(TIMEOUT) == 130, run.output
    assert re.fullmatch(r'sweep: interrupted after 0 of 3 runs, which are in \S+', run.stderr), run.stderr
    wait_until(lambda: not marked(mark), TIMEOUT, lambda: f'an end of {marked(mark)}')


def test_a_session_that_breaks_is_replaced_once(monkeypatch):
    class Broken:
        """A session whose second run fails, and each without a value."""

        made = runs = 0

        def __init__(self):
            Broken.made += 1

        def run(self, _subject, parameters):
            self.runs += 1
            if self.runs > 1 or parameters['x'] is None:
                raise RunError('broken')
            return self.runs

        def close(self):
            pass

    monkeypatch.setattr(session_process, 'SessionProcess', Broken)
    subject = Launched(['guest', 'nodes.launch'], 1.0)
    assert [session_process.run_in_session(subject, {'x': 1, 'seed': seed}) for seed in range(3)] == [1, 1, 1]
    assert Broken.made == 3
    with pytest.raises(RunError):
        session_process.run_in_session(subject, {'x': None, 'seed': 0})


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
    printed = sweep('guest', 'helper.launch', '--until', '2', '--set', 'launch:x=done', '--set', 'x=1',
                    command=SCRIPT, timeout=60.0).stdout
    row, = rows_in(folder_of(printed))
    assert (row['ended'], row['x'], row['launch:x']) == ('until', '1', 'done')


def test_a_sweep_in_which_no_command_reaches_the_robot_says_so():
    printed = sweep('guest', 'early.launch', '--until', '1', command=SCRIPT).stdout
    assert 'no commands     reached the robot, with all runs: ' in printed, printed


@pytest.mark.parametrize('launched, values, line', [
    (('guest', 'plain.launch', 1), {}, 'plain.launch: node plain, guest/plain.py, is not there, or not executable'),
    (('guest', 'elsewhere.launch', 1), {}, 'elsewhere.launch: node node, guest/node.py, has a ROS_MASTER_URI of'),
    (('guest', 'nodes.launch', 1), {'ends': [1]}, 'parameter ends cannot be set in a sweep of nodes.launch: did you mean end?'),
    (('guest', 'nodes.launch', 1), {'lockstep': [False]}, 'parameter lockstep cannot be set in a sweep of'),
    (('guest', 'nodes.launch', 1), {'wheel_slip': [1]}, 'parameter ~wheel_slip is 1, but must be'),
    (('guest', 'nodes.launch', 1), {'scan_rate': [5], 'clock_rate': [10], 'odom_rate': [20]},
     'parameter ~clock_rate is 10, but must be a number 0 or from ~odom_rate (20) to 1000 Hz'),
    (('guest', 'nodes.launch', 0), {}, 'until is 0, but must be a number from 0.05'),
    (('guest', 'typed.launch', 1), {'type': ['node.py', 'none.py']}, 'node node, guest/none.py, is not there'),
    (('guest', 'typed.launch', 1), {'type': ['node.py'], 'time': [2]}, 'parameter time cannot be set in a sweep of typed'),
    (('guest', 'stranger.launch', 1), {}, 'node node, stranger/node.py, is not there'),
    (('guest', 'missing.launch', 1), {}, 'missing.launch: stranger'),
    (('guest', 'eval.launch', 1), {}, 'eval.launch: division by zero'),
    (('guest', 'remote.launch', 1), {}, 'node node, guest/node.py, is for the machine other, where the robot is not'),
    (('guest', 'robot.launch', 1), {}, 'robot.launch: a node has the name of the robot, sim_turtlebot'),
    (('guest', 'sim.launch', 1), {}, 'sim.launch starts a robot, but there is one already'),
    (('guest', 'none.launch', 1), {}, 'none.launch starts no node'),
    (('guest', 'other.launch', 1), {}, 'other.launch] is neither a launch file in package'),
    ((str(EXAMPLE / 'launch' / 'one_metre.launch'), 'x', 1), {}, 'there is no package /')])
def test_a_launch_file_that_cannot_be_swept_is_one_line(launched, values, line):
    with pytest.raises(StartError) as refusal:
        Campaign(Launched([*launched[:2]], launched[2]), 1, values, {}).check()
    assert line in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
