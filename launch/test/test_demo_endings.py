"""However and whenever the demo is ended, nothing that it has started is left."""

import contextlib
import os
import signal
import socket
import subprocess
import time

import pytest
from odometry_tests.linux import assert_loopback_only, marked, new_mark, wait_until_none
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
def demo():
    """Start a demo that nothing else looks after; yield it, its output and its mark.

    At the end nothing of it may be left, and its port must be free.
    """
    mark = new_mark()
    with hold_port() as port, open(os.memfd_create('output'), 'r+b') as output:
        process = subprocess.Popen(
            COMMAND, stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
            env={**os.environ, **mark, 'ROS_MASTER_URI': f'http://localhost:{port}'})
        try:
            yield process, lambda: os.pread(output.fileno(), 10**6, 0).decode(), mark
            wait_until_none(mark)
            assert_that_nobody_listens(port)
        finally:
            for pid in marked(mark):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            process.wait()


def end(process, signum, output):
    """Send a signal, those of keys to the group as a terminal does, and check what comes of it."""
    if signum in (signal.SIGINT, signal.SIGQUIT):
        os.killpg(process.pid, signum)
    else:
        process.send_signal(signum)
    assert process.wait() in (-signum, 128 + signum), output()
    assert 'Traceback' not in output()


def assert_that_nobody_listens(port):
    """Assert that the next demo can have the port."""
    with socket.socket() as probe:
        assert probe.connect_ex(('localhost', port)) != 0


@pytest.mark.parametrize('driving, moment, signum', MOMENTS)
def test_nothing_is_left_of_a_demo_that_is_ended(driving, moment, signum):
    with demo() as (process, output, mark):
        if driving:
            wait_until(lambda: PROGRESS in output(), 60.0, output)
            assert len(marked(mark)) > 4
            assert_loopback_only(process.pid)
        time.sleep(moment)
        end(process, signum, output)


def test_ctrl_c_on_a_terminal_leaves_a_line_for_the_prompt_and_nothing_else():
    mark = new_mark()
    with hold_port() as port:
        with Terminal(ROOT, {**os.environ, **mark,
                             'ROS_MASTER_URI': f'http://localhost:{port}'}) as terminal:
            terminal.type('./ws demo --distance 100')
            terminal.wait_for_output(PROGRESS, 60.0)
            for _ in range(5):
                terminal.press_ctrl_c()
            assert terminal.wait_for_prompt() == 128 + signal.SIGINT, terminal.output
        wait_until_none(mark)
        assert_that_nobody_listens(port)
    assert terminal.lines[-1] == '', f'no line for the prompt after:\n{terminal.output}'
    assert f'{PROGRESS}, ' in terminal.lines[-2], terminal.output
    assert 'Traceback' not in terminal.output
