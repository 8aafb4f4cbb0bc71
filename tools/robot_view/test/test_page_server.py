"""How the viewer starts and ends, one line each, and whom the page's server admits."""

import os
import signal
import socket

import pytest
from odometry_common.parameters import ParameterError, StartError
from odometry_tests.linux import assert_loopback_only
from odometry_tests.processes import assert_refused, hold_port, rosrun
from robot_view.address import read_address
from viewer import viewing

viser = pytest.importorskip('viser', reason='viser is not installed')

from robot_view.server import is_own, start_server
from websockets.asyncio import server

NAMES = {'localhost', '127.0.0.1', '[::1]', 'robots.example', 'lab:9000', '192.168.1.5', 'fd00::5'}


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_it_prints_the_url_and_exits_quietly(master, signum):
    with viewing() as view:
        with socket.create_connection(('127.0.0.1', view.port)):
            pass
        assert_loopback_only(view.pid)
        assert view.end(signum) == 0, view.output
    assert view.output.split('\n') == [f'view: {view.url}', '']


def test_without_viser_it_says_what_to_install(master, tmp_path):
    (tmp_path / 'viser.py').write_text("raise ModuleNotFoundError(name='viser')\n")
    path = f'{tmp_path}:{os.environ["PYTHONPATH"]}'
    with hold_port() as port, rosrun('robot_view', 'view.py', f'_port:={port}',
                                     env={'PYTHONPATH': path}) as viewer:
        assert_refused(viewer, 'viser is not installed', 'tools/robot_view/requirements.txt')


@pytest.mark.parametrize('host, origin', [
    ('localhost:8080', ''), ('LOCALHOST:8080', 'http://localhost:8080'), ('localhost', 'http://localhost'),
    ('localhost:9000', 'http://localhost:9000'), ('[fd00::5]:8080', 'http://[fd00::5]:8080'),
    ('robots.example', 'https://robots.example'), ('lab:9000', 'http://lab:9000')])
def test_the_page_is_admitted_under_each_of_its_names(host, origin):
    """With any port, which a forwarded port changes."""
    assert is_own(NAMES, host, origin)


@pytest.mark.parametrize('host, origin', [
    ('localhost:8080', 'http://evil.example'), ('localhost:8080', 'http://localhost:3000'),
    ('localhost:8080', 'http://localhost:8080.evil.example'), ('localhost:8080', 'null'),
    ('localhost:8080', 'localhost:8080'),
    ('localhost:8080', 'http://localhost:8080, http://localhost:8080'), ('lab:9001', 'http://lab:9001'),
    ('evil.example:8080', 'http://evil.example:8080'), ('x.robots.example', ''), ('', ''),
    ('evil.example@localhost:8080', '')])
def test_others_are_not(host, origin):
    """Other pages, names that somebody redirects to this machine, broken headers."""
    assert not is_own(NAMES, host, origin)


def test_a_codespace_forwards_the_page(monkeypatch):
    """To localhost, with the browser's Origin, or with its own name as Host; no other Codespace does."""
    monkeypatch.setenv('CODESPACE_NAME', 'Fluffy-Disco-x7')
    monkeypatch.setenv('GITHUB_CODESPACES_PORT_FORWARDING_DOMAIN', 'app.github.dev')
    with hold_port() as port:
        address = read_address({'port': port})
    forwarded, other = (f'{name}-{port}.app.github.dev' for name in ('fluffy-disco-x7', 'other'))

    def admits(host, name):
        return is_own(address.names, host, f'https://{name}', address.origins)

    assert admits(f'localhost:{port}', forwarded) and admits(forwarded, forwarded)
    assert not admits(f'localhost:{port}', other) and not admits(other, other)
    assert not is_own(address.names, f'localhost:{port}', f'http://{forwarded}', address.origins)


@pytest.mark.parametrize('host, url', [('localhost', 'http://localhost'), ('0.0.0.0', 'http://localhost'),
                                       ('127.0.0.2', 'http://127.0.0.2')])
def test_the_page_has_a_url_that_every_browser_finds(monkeypatch, host, url):
    """0.0.0.0 is an address to listen on; not every browser takes it for this machine. A variable sets the default."""
    with hold_port(host) as port:
        monkeypatch.setenv('ODOMETRY_VIEW_HOST', '127.0.0.3')
        address = read_address({'host': host, 'port': port, 'allowed_hosts': 'LAB:81, b'})
        monkeypatch.setenv('ODOMETRY_VIEW_HOST', host)
        assert read_address({'port': port}).url == address.url
    assert address.url == f'{url}:{port}'
    assert {'localhost', host, 'lab:81', 'b'} <= address.names


def test_a_port_that_is_taken_is_refused():
    with socket.create_server(('127.0.0.1', 0)) as other, pytest.raises(ParameterError, match='~port .* free port'):
        read_address({'port': other.getsockname()[1]})


@pytest.mark.parametrize('host', ['a..b', 64 * 'a'])
def test_a_name_that_no_host_can_have_is_refused(host):
    with pytest.raises(ParameterError, match='~host'):
        read_address({'host': host})


def test_without_its_guard_the_page_does_not_start(monkeypatch):
    """As with a version of viser that starts its server in another way."""
    serve = server.serve
    monkeypatch.setattr(viser, 'ViserServer', lambda *_, **__: None)
    with hold_port() as port, pytest.raises(StartError, match='version'):
        start_server(read_address({'port': port}))
    assert server.serve is serve
