"""However and whenever the demo is ended, nothing that it has started is left."""

import contextlib
import os
import signal
import socket
import subprocess
import time

import pytest
from odometry_tests.linux import assert_loopback_only, marked, signals
from odometry_tests.processes import hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until

COMMAND = [ROOT / 'ws', 'demo', '--distance', '100']
PROGRESS = ' of 100.00 m'
# Whether it drives already, how long (s) after that or after the start, and the signal.
MOMENTS = [(False, 0.5, signal.SIGTERM), (False, 1.1, signal.SIGINT), (True, 0.1, signal.SIGKILL),
           *(pytest.param(*moment, marks=pytest.mark.nightly) for moment in (
               (False, 0.15, signal.SIGINT), (False, 1.6, signal.SIGKILL), (False, 2.2, signal.SIGQUIT),
               (True, 0.3, signal.SIGHUP)))]


@contextlib.contextmanager
def nothing_left(mark):
    """Yield an environment for a demo, of which nothing may be left at the end; its port must be free."""
    with hold_port() as port:
        try:
            yield {**os.environ, 'ROS_MASTER_URI': f'http://localhost:{port}'}
            # Each look goes through all processes there are.
            wait_until(lambda: not marked(mark), 15.0, period=0.2, what=lambda: (
                f'the end of {[process.info["cmdline"] for process in marked(mark)]}'))
            socket.create_server(('localhost', port)).close()
        finally:
            for process in marked(mark):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process.pid, signal.SIGKILL)


@pytest.mark.parametrize('driving, moment, signum', MOMENTS)
def test_nothing_is_left_of_a_demo_that_is_ended(driving, moment, signum, mark, tmp_path):
    """By a signal, those of keys to the group as a terminal sends them; nothing else looks after it."""
    output = tmp_path / 'output'
    with nothing_left(mark) as environment, output.open('w') as file:
        process = subprocess.Popen(COMMAND, stdout=file, stderr=subprocess.STDOUT,
                                   start_new_session=True, env=environment)
        if driving:
            wait_until(lambda: PROGRESS in output.read_text(), 60.0, output.read_text)
            assert len(marked(mark)) > 4
            assert_loopback_only(process.pid)
        time.sleep(moment)
        if signum in (signal.SIGINT, signal.SIGQUIT):
            os.killpg(process.pid, signum)
        else:
            process.send_signal(signum)
        assert process.wait() in (-signum, 128 + signum), output.read_text()
    assert 'Traceback' not in output.read_text()


def test_ctrl_c_is_blocked_while_the_python_of_the_reaper_starts():
    """It would print a traceback."""
    with subprocess.Popen([ROOT / 'ws', 'demo', '--help'], stdout=subprocess.DEVNULL) as process:
        wait_until(lambda: 'python' in os.readlink(f'/proc/{process.pid}/exe'), 60.0, 'a reaper', period=0.0)
        assert signal.SIGINT in signals(process.pid, 'SigBlk')


def test_ctrl_c_on_a_terminal_leaves_a_line_for_the_prompt_and_nothing_else(mark):
    with nothing_left(mark) as environment, Terminal(ROOT, environment) as terminal:
        terminal.type('./ws demo --distance 100')
        terminal.wait_for_output(PROGRESS, 60.0)
        for _ in range(5):
            terminal.press_ctrl_c()
        assert terminal.wait_for_prompt() == 128 + signal.SIGINT, terminal.output
    assert terminal.lines[-1] == '', f'no line for the prompt after:\n{terminal.output}'
    assert f'{PROGRESS}, ' in terminal.lines[-2], terminal.output
    assert 'Traceback' not in terminal.output
