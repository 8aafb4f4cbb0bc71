"""A viewer, and a browser for its page."""

import contextlib
import sys

import pytest
from odometry_tests.processes import Process, hold_port, path_of

DARK = 80  # of 255; the robot is darker than this, the floor and the marks are not

# Its pad waits for ever for a page that falls silent: a test sees what else stops the robot.
PATIENT_VIEWER = '''
import runpy, sys
from robot_view import steering
steering.HOLD_TIMEOUT = float('inf')
runpy.run_path(sys.argv.pop(1), run_name='__main__')
'''


@contextlib.contextmanager
def viewing(*arguments, patient=False):
    """Start a viewer on a free port; yield its Process, with its port and url, once it serves the page.

    Without viser the test that needs it is skipped.

    :param patient: whether a button is held until it is released, even by a page that hangs
    """
    pytest.importorskip('viser', reason='viser is not installed')
    script = path_of('robot_view', 'view.py')
    command = [sys.executable, '-c', PATIENT_VIEWER, script] if patient else [script]
    with hold_port() as port, Process(*command, f'_port:={port}', *arguments) as view:
        view.port, view.url = port, f'http://localhost:{port}'
        view.wait_for_output(f'view: {view.url}')
        yield view


@contextlib.contextmanager
def browsing():
    """Yield a function that opens a browser.Page by its address; the pages close at the end."""
    browser = pytest.importorskip('browser', reason='selenium is not installed')
    if not (browser.CHROMIUM and browser.DRIVER):
        pytest.skip('chromium and chromedriver are not installed')
    with contextlib.ExitStack() as stack:
        yield lambda url: stack.enter_context(browser.Page()).open(url)
