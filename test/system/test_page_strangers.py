"""Strangers at the page's port: they get no connection, and a line in the log."""

import contextlib
import http.client
import socket
import time

import pytest
from odometry_tests.viewing import View
from odometry_tests.waiting import PATIENCE, TIMEOUT

raw_page = pytest.importorskip('odometry_tests.raw_page', reason='viser is not installed')
from websockets.exceptions import InvalidStatus

LOG_PERIOD = 10.0  # s


@pytest.fixture(scope='module')
def view(master):
    """Start a viewer that is reached by two more names."""
    with raw_page.view_of_two('/strange', '_allowed_hosts:=robots.example, lab:9000') as running:
        yield running


def connect(view, host, origin):
    """Connect to the page's websocket with these headers, in which the port is still to be named."""
    return raw_page.RawPage(view.port, *(header and header.format(port=view.port)
                                         for header in (host, origin)))


@pytest.mark.parametrize('host, origin', [
    (None, 'http://evil.example'),
    (None, 'http://localhost:1'),
    (None, 'null'),
    (None, 'file://'),
    ('evil.example:{port}', 'http://evil.example:{port}'),
    ('evil.example:{port}', None),
    ('evil.example', 'http://localhost:{port}'),
    ('localhost:9000', 'http://localhost:{port}'),
    ('lab:9001', 'http://lab:9001'),
    ('localhost.evil.example:{port}', None),
])
def test_a_stranger_gets_no_websocket(view, host, origin):
    """403, and a line in the log that names it."""
    with pytest.raises(InvalidStatus) as refusal:
        connect(view, host, origin)
    assert refusal.value.response.status_code == 403


@pytest.mark.parametrize('host, origin', [
    (None, None),
    (None, 'http://localhost:{port}'),
    ('127.0.0.1:{port}', 'http://127.0.0.1:{port}'),
    ('[::1]:{port}', 'http://[::1]:{port}'),
    ('localhost:9000', 'http://localhost:9000'),
    ('robots.example', 'https://robots.example'),
    ('lab:9000', 'http://lab:9000'),
])
def test_the_page_itself_gets_one_whatever_its_address(view, host, origin):
    """Also through a forwarded port and through a proxy."""
    with connect(view, host, origin) as page:
        page.find('forward')


def fetch(view, host):
    """Return status, text and headers of the page, asked for at a host."""
    connection = http.client.HTTPConnection('localhost', view.port, timeout=TIMEOUT * PATIENCE)
    with contextlib.closing(connection):
        connection.request('GET', '/', headers={'Host': host})
        answer = connection.getresponse()
        return answer.status, answer.read(), answer.headers


def test_a_name_that_somebody_bends_to_this_machine_gets_no_page(view):
    """As DNS rebinding does."""
    assert fetch(view, f'evil.example:{view.port}')[0] == 403


def test_a_page_of_somebody_else_may_not_frame_it(view):
    """A click that was meant for the other page would drive."""
    status, text, headers = fetch(view, f'localhost:{view.port}')
    assert status == 200 and b'viser' in text.lower()
    assert headers['Content-Security-Policy'] == "frame-ancestors 'self'"


@pytest.mark.parametrize('noise', [b'', b'\x16\x03\x01\x02\x00\x01', b'GET / HTTP/1.1\r\n\r\n',
                                   b'GET / HTTP/1.1\r\nHost: \x1b[2J\r\n\r\n', b'x' * 100000])
def test_noise_at_the_port_is_no_error(view, noise):
    """Nothing but warnings in the log, and the page is there for the next one."""
    with socket.create_connection(('localhost', view.port)) as stranger, \
            contextlib.suppress(ConnectionError):
        stranger.sendall(noise)
        stranger.shutdown(socket.SHUT_WR)
        stranger.recv(4096)
    assert fetch(view, f'localhost:{view.port}')[0] == 200
    assert not [line for line in view.process.stderr.splitlines() if '[WARN]' not in line]


def test_the_log_has_one_line_for_many_strangers(master):
    """It names the first, in printable characters; no page is needed for it."""
    origin = b'http://evil.example\xff ' + b'x' * 5000
    with View() as view:
        began = time.monotonic()
        for _ in range(20):
            with socket.create_connection(('localhost', view.port)) as stranger:
                stranger.sendall(b'GET / HTTP/1.1\r\nHost: localhost:%d\r\nOrigin: %s\r\n\r\n'
                                 % (view.port, origin))
                assert stranger.makefile('rb').readline().split()[1] == b'403'
        view.process.wait_for_output('refused')
        assert view.process.end() == 0, view.process.output
    lines = view.process.stderr.splitlines()
    assert len(lines) <= 1 + (time.monotonic() - began) / LOG_PERIOD, lines
    assert 'http://evil.example\\' in lines[0] and lines[0].isascii()
    assert len(lines[0]) < 400
