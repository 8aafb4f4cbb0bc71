"""The demo notices what becomes of its nodes, its output and its disk, and says so in one line."""

import os
import re
import shutil
import signal

import pytest
from odometry_tests.forms import number_after
from odometry_tests.links import pid_of
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT

SHORT = '--distance 0.3 --real-time-factor 0'
KILOBYTES = 100  # more than the logs of a run need, and less than its bag
ROTATE_TIME = 10.0  # s of simulated time; to -135 degrees it takes 14


@pytest.fixture
def slow_programs(tmp_path):
    """Return a folder for PATH with programs of a machine that is slow.

    After 5 s matplotlib would tell whoever watches the robot that it builds its font cache. For a
    master of its own roslaunch waits 10 s.
    """
    for name, line in (('fc-list', 'sleep 6'),
                       ('rosmaster', f'sleep 11; exec {shutil.which("rosmaster")} "$@"')):
        program = tmp_path / name
        program.write_text(f'#!/bin/sh\n{line}\n')
        program.chmod(0o755)
    return tmp_path


def run(line, **env):
    """Run a line of bash in this project to its end and return its process."""
    process = Process('bash', '-o', 'pipefail', '-c', line, cwd=ROOT, env=env)
    process.wait(90.0)
    return process


@pytest.mark.parametrize('command, node, signum, how', [
    ('move --distance 100', 'test_movement', signal.SIGKILL, ' by SIGKILL'),
    ('move --distance 100', 'movement_detector_node', signal.SIGTERM, ''),
    ('rotate --target 180', 'sim_turtlebot', signal.SIGKILL, '')])
def test_the_demo_ends_when_a_node_has_ended(command, node, signum, how):
    """With one line that names it, instead of the same progress for ever."""
    with hold_port() as port, Process(
            ROOT / 'ws', 'demo', *command.split(), '--real-time-factor', '0.5',
            env={'ROS_MASTER_URI': f'http://localhost:{port}'}) as demo:
        demo.wait_for_output(' s\n', 60.0)
        os.kill(pid_of(f'/{node}', f'http://localhost:{port}'), signum)
        assert demo.wait(30.0) == 1, demo.output
    assert demo.stderr == f'demo: {node} has ended{how}', demo.output


def test_it_turns_to_a_heading_in_an_odd_environment(slow_programs, tmp_path):
    """Settings that make no sense are not used; logs go where they can be written, for so long.

    The ROS master is waited for, and the robot followed from its start, whatever matplotlib does.
    """
    temporary = tmp_path / 'temporary'
    temporary.mkdir()
    demo = run('./ws demo rotate --target -135 --real-time-factor 0', HOME='/dev/null',
               ROS_NAMESPACE='elsewhere', ROS_MASTER_URI='http://localhost:none',
               MPLBACKEND='module://matplotlib_inline.backend_inline',
               TMPDIR=str(temporary), PATH=f'{slow_programs}:{os.environ["PATH"]}')
    assert demo.wait() == 0, demo.output
    assert re.fullmatch(rf'demo: until the end logs are in {temporary}/\S+: .*', demo.stderr)
    assert not list(temporary.iterdir())
    assert number_after('heading', demo.stdout) == pytest.approx(-135, abs=0.1)
    assert number_after('time', demo.stdout) > ROTATE_TIME, demo.output
    assert 'picture' in demo.stdout


def test_ctrl_c_leaves_no_folder_for_logs(tmp_path):
    """Where they could not be written as usual."""
    with hold_port() as port, Process(
            ROOT / 'ws', 'demo', *SHORT.split(), '--real-time-factor', '0.1', env={
                'ROS_MASTER_URI': f'http://localhost:{port}', 'HOME': '/dev/null',
                'TMPDIR': str(tmp_path)}) as demo:
        demo.wait_for_output(' of 0.30 m', 60.0)
        assert list(tmp_path.iterdir())
        assert demo.end(signal.SIGINT) == 128 + signal.SIGINT, demo.output
    assert not list(tmp_path.iterdir())


def test_it_drives_as_it_is_told_when_the_disk_is_full():
    """So far and so fast, backwards and however it is written; without a recording and a picture."""
    demo = run(f'ulimit -f {KILOBYTES}; ./ws demo --distance 1 --speed -2e-1 --real-time-factor 0')
    assert demo.wait() == 0, demo.output
    assert re.fullmatch('demo: the recording ends: .*File too large', demo.stderr), demo.output
    # In lockstep the machine's pace is not in the distance.
    assert number_after('moved distance', demo.stdout) == 1.011
    assert number_after('true distance', demo.stdout) == 1.011
    assert 'picture' not in demo.stdout


@pytest.mark.parametrize('limit, line', [
    ('-v 500000', r'demo: the address space is limited to 500000 kB \(ulimit -v\), but must be .*'),
    ('-f 0', r'\./ws: nothing can be written to \S+: .*')])
def test_a_limit_under_which_it_cannot_drive_is_named_in_one_line(limit, line):
    """Instead of threads that cannot start and those that wait for them."""
    demo = run(f'ulimit {limit}; ./ws demo')
    assert (demo.wait(), demo.stdout) == (1, ''), demo.output
    assert re.fullmatch(line, demo.stderr), demo.output


@pytest.mark.parametrize('output, status', [('>&-', 0), ('| head -n 1', 128 + signal.SIGPIPE)])
def test_it_is_quiet_when_nobody_listens(output, status):
    """No traceback of Python's own end either."""
    demo = run(f'./ws demo {SHORT} {output}')
    assert (demo.wait(), demo.stderr) == (status, ''), demo.output


def test_a_window_without_a_screen_is_refused_in_one_line():
    """The simulator's own."""
    demo = run('./ws demo --gui', DISPLAY='')
    assert demo.wait() == 1, demo.output
    assert re.fullmatch('demo: sim_turtlebot: parameter ~gui is True, .*', demo.stderr), demo.output


def test_demos_that_start_together_all_arrive():
    """Beside one that has the usual port: each says where its master is, and has its own folder."""
    with hold_port() as port:
        usual = {'ROS_MASTER_URI': f'http://localhost:{port}'}
        with Process(ROOT / 'ws', 'demo', '--distance', '100', env=usual) as first:
            first.wait_for_output(' of 100.00 m', 60.0)
            demos = [Process(ROOT / 'ws', 'demo', *SHORT.split(), env=usual) for _ in range(2)]
            for demo in demos:
                assert demo.wait(90.0) == 0, demo.output
    output = '\n'.join(demo.output for demo in demos)
    told = re.findall('^rostopic in another terminal: export ROS_MASTER_URI=(.*)$', output,
                      re.MULTILINE)
    assert len(told) == len({usual['ROS_MASTER_URI'], *told}) - 1 == 2, output
    assert len(set(re.findall('^picture +(.*)', output, re.MULTILINE))) == 2, output
    assert 'export ROS_MASTER_URI' not in first.stdout
