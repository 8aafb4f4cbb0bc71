"""The page beside the demo and beside a launch file."""

import contextlib
import os
import re
import socket
import urllib.request

import pytest
from odometry_tests.linux import assert_loopback_only
from odometry_tests.processes import hold_port, run
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import PATIENCE, TIMEOUT
from odometry_tools.runs.options import PAGE_PORT

ADDRESS = re.compile(r'^view            (http://localhost:(\d+))$', re.MULTILINE)
STAYS = 'The page stays'

pytest.importorskip('robot_view', reason='the page is left out')
pytest.importorskip('viser', reason='viser is not installed')


def test_on_a_terminal_the_progress_is_one_line_and_the_page_stays_after_the_run():
    """The line is rewritten in place up to a full bar; Ctrl-C at the page is no failure."""
    with hold_port() as master_port, Terminal(
            ROOT, {**os.environ, 'ROS_MASTER_URI': f'http://localhost:{master_port}'}) as terminal:
        terminal.type('./ws demo --view --distance 0.15 --speed 0.05 --real-time-factor 3')
        terminal.wait_for_output(STAYS, 60.0)
        url, port = ADDRESS.search('\n'.join(terminal.lines)).groups()
        with urllib.request.urlopen(url, timeout=TIMEOUT * PATIENCE) as answer:
            assert b'viser' in answer.read().lower()
        assert_loopback_only(terminal.pid)
        terminal.press_ctrl_c()
        assert terminal.wait_for_prompt() == 0, terminal.output
    assert re.search(r'\r\x1b\[K\[={30}\] 0\.15 of 0\.15 m, [^\r]*\r\n', terminal.text), terminal.text
    assert 'moved distance' in terminal.output and 'Traceback' not in terminal.output
    socket.create_server(('localhost', int(port))).close()


@pytest.mark.nightly
def test_without_a_terminal_the_demo_ends_as_without_a_page():
    """Nobody could press Ctrl-C. If the usual port is taken, the page has a later one."""
    with contextlib.ExitStack() as stack:
        with contextlib.suppress(OSError):  # somebody else has taken it
            stack.enter_context(socket.create_server(('localhost', PAGE_PORT)))
        demo = run(ROOT / 'ws', 'demo', '--view', 'rotate', '--target', '20', '--real-time-factor', '0', timeout=60.0)
    assert STAYS not in demo.stdout
    assert PAGE_PORT <= int(ADDRESS.search(demo.stdout)[2]) < PAGE_PORT + 100, demo.output
