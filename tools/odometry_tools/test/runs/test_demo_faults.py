"""The demo notices what becomes of its nodes, its output and its disk, and says so in one line."""

import os
import re
import shutil
import signal

import pytest
from odometry_tests.forms import number_after
from odometry_tests.links import pid_of
from odometry_tests.processes import Process, hold_port, run
from odometry_tests.scripts import ROOT

SHORT = './ws demo --distance 0.3 --real-time-factor 0'
KILOBYTES = 100  # more than the logs of a run need, and less than its bag
ROTATE_TIME = 10.0  # s of simulated time; to -135 degrees it takes 14


def run_line(line, status=0, **env):
    return run('bash', '-o', 'pipefail', '-c', line, cwd=ROOT, status=status, timeout=90.0, env=env)


def test_the_demo_ends_when_a_node_has_ended():
    with hold_port() as port, Process(
            ROOT / 'ws', 'demo', '--distance', '100',
            env={'ROS_MASTER_URI': f'http://localhost:{port}'}) as demo:
        demo.wait_for_output(' s\n', 60.0)
        os.kill(pid_of('/test_movement', f'http://localhost:{port}'), signal.SIGKILL)
        assert demo.wait(30.0) == 1, demo.output
    assert demo.stderr == 'demo: test_movement has ended by a signal (Killed)', demo.output


@pytest.mark.nightly
def test_it_turns_to_a_heading_in_an_odd_environment(tmp_path):
    """Settings that make no sense are not used; logs go where they can be written.

    The demo waits for the ROS master, and follows the robot from its start, whatever matplotlib does.
    """
    # As on a slow machine: roslaunch waits only 10 s for its master, and after 5 s matplotlib would
    # print that it builds its font cache.
    for name, line in (('fc-list', 'sleep 6'),
                       ('rosmaster', f'sleep 11; exec {shutil.which("rosmaster")} "$@"')):
        program = tmp_path / name
        program.write_text(f'#!/bin/sh\n{line}\n')
        program.chmod(0o755)
    temporary = tmp_path / 'temporary'
    temporary.mkdir()
    demo = run_line('./ws demo rotate --target -135 --real-time-factor 0', HOME='/dev/null',
               ROS_NAMESPACE='elsewhere', ROS_MASTER_URI='http://localhost:none',
               MPLBACKEND='module://matplotlib_inline.backend_inline',
               TMPDIR=str(temporary), PATH=f'{tmp_path}:{os.environ["PATH"]}')
    logs, = temporary.iterdir()
    assert demo.stderr.startswith(f'demo: logs are in {logs}: ') and any(logs.iterdir())
    assert number_after('heading', demo.stdout) == pytest.approx(-135, abs=0.1)
    assert number_after('time', demo.stdout) > ROTATE_TIME, demo.output
    assert 'picture' in demo.stdout


@pytest.mark.parametrize('home', ['', '/dev/null'])
def test_the_logs_are_where_the_user_wishes(home, tmp_path):
    """Without a ~/.ros, as on every CI, or where there can be none."""
    demo = run_line(SHORT, HOME=home or str(tmp_path), ROS_LOG_DIR=str(tmp_path / 'logs'))
    assert not demo.stderr
    assert any((tmp_path / 'logs').iterdir())


@pytest.mark.nightly
def test_it_drives_backwards_when_the_disk_is_full():
    demo = run_line(f'ulimit -f {KILOBYTES}; ./ws demo --distance 1 --speed -0.2 --real-time-factor 0')
    assert re.fullmatch('demo: the recording ends: .*File too large', demo.stderr), demo.output
    assert number_after('moved distance', demo.stdout) == 1.011
    assert 'picture' not in demo.stdout


@pytest.mark.parametrize('line, message', [
    # cat, which has no limit, writes the message to the file.
    ('(ulimit -f 0; ./ws demo) 2>&1 | cat >&2', r'\./ws: \S+/setup.bash fails: OSError: .* File too large'),
    ('DISPLAY= ./ws demo --gui', 'demo: sim_turtlebot: parameter ~gui is True, .*')])
def test_what_it_cannot_drive_without_is_named_in_one_line(line, message):
    demo = run_line(line, status=1)
    assert re.fullmatch(message, demo.stderr), demo.output


def test_it_is_quiet_when_nobody_reads_its_output():
    demo = run_line(f'{SHORT} | head -n 1', status=128 + signal.SIGPIPE)
    assert not demo.stderr
