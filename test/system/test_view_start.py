"""How the viewer starts and ends: one line each, whatever is in its way."""

import importlib.util
import os
import signal
import socket

import pytest
from odometry_tests.processes import hold_port, rosrun

EXIT_BAD_PARAMETER = 2
NEEDS_VISER = pytest.mark.skipif(importlib.util.find_spec('viser') is None,
                                 reason='viser is not installed')


def view(*arguments, **options):
    """Start a viewer."""
    return rosrun('sim_turtlebot', 'view.py', *arguments, **options)


def assert_refused(viewer, *words):
    """Assert that the viewer ends with status 2 and one line with all the words in it."""
    assert viewer.wait() == EXIT_BAD_PARAMETER, viewer.output
    assert len(viewer.stderr.splitlines()) == 1, viewer.stderr
    for word in words:
        assert word in viewer.stderr


@NEEDS_VISER
@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_says_where_the_page_is_and_ends_quietly(master, signum):
    """One line on stdout, nothing else, exit status 0."""
    with hold_port() as port, view(f'_port:={port}') as viewer:
        viewer.wait_for_output('view: ')
        assert viewer.end(signum) == 0, viewer.output
    assert viewer.output.split('\n') == [f'view: http://localhost:{port}', '']


@NEEDS_VISER
def test_it_listens_on_loopback_only(master):
    """The network would get a robot to drive."""
    with hold_port() as port, view(f'_port:={port}') as viewer:
        viewer.wait_for_output('view: ')
        with socket.create_connection(('127.0.0.1', port)):
            pass
        with socket.socket() as elsewhere:
            # The port is taken on 127.0.0.1 alone, not on all addresses of the machine.
            elsewhere.bind(('127.0.0.2', port))


@NEEDS_VISER
def test_a_port_that_is_taken_is_refused(master):
    """It does not look for another one, where nobody would look for the page."""
    with socket.socket() as other:
        other.bind(('127.0.0.1', 0))
        other.listen()
        port = other.getsockname()[1]
        with view(f'_port:={port}') as viewer:
            assert_refused(viewer, f'parameter ~port is {port}')


def test_without_viser_it_says_what_to_install(master, tmp_path):
    """The package works without it, but for the page."""
    (tmp_path / 'viser.py').write_text("raise ModuleNotFoundError(name='viser')\n")
    path = f'{tmp_path}:{os.environ["PYTHONPATH"]}'
    with hold_port() as port, view(f'_port:={port}', env={'PYTHONPATH': path}) as viewer:
        assert_refused(viewer, 'is not installed', 'requirements-view.txt')
