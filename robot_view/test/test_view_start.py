"""How the viewer starts and ends: one line each, whatever is in its way."""

import os
import signal
import socket

import pytest
from odometry_tests.linux import assert_loopback_only
from odometry_tests.processes import assert_refused, hold_port, rosrun
from viewer import viewing


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_prints_the_url_and_exits_quietly(master, signum):
    with viewing() as view:
        with socket.create_connection(('127.0.0.1', view.port)):
            pass
        assert_loopback_only(view.pid)
        assert view.end(signum) == 0, view.output
    assert view.output.split('\n') == [f'view: {view.url}', '']


@pytest.mark.parametrize('arguments, address', [([], '127.0.0.2'), (['_host:=localhost'], 'localhost')])
def test_an_environment_variable_sets_the_default_of_host(master, arguments, address):
    pytest.importorskip('viser', reason='viser is not installed')
    with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}', *arguments,
                                     env={'ODOMETRY_VIEW_HOST': '127.0.0.2'}) as viewer:
        viewer.wait_for_output(f'view: http://{address}:{port}')
        with socket.create_connection((address, port)):
            pass


def test_a_port_that_is_taken_is_refused(master):
    pytest.importorskip('viser', reason='viser is not installed')
    with socket.create_server(('127.0.0.1', 0)) as other:
        port = other.getsockname()[1]
        with rosrun('robot_view', 'view.py', f'_port:={port}') as viewer:
            assert_refused(viewer, f'parameter ~port is {port}')


def test_without_viser_it_says_what_to_install(master, tmp_path):
    (tmp_path / 'viser.py').write_text("raise ModuleNotFoundError(name='viser')\n")
    path = f'{tmp_path}:{os.environ["PYTHONPATH"]}'
    with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}',
                                     env={'PYTHONPATH': path}) as viewer:
        assert_refused(viewer, 'viser is not installed', 'robot_view/requirements.txt')
