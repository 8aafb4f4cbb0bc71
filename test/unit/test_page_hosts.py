"""Who gets in at the page's port, decided by the headers that a browser writes."""

import socket

import pytest
from hypothesis import given
from hypothesis import strategies as st
from robot_view.address import Address
from robot_view.hosts import Host, OwnHosts, parse_host, parse_hosts

LOOPBACK = OwnHosts('localhost')
NAMED = OwnHosts('localhost', parse_hosts('Robots.example, lab:9000'))
NETWORK = OwnHosts('0.0.0.0')
HERE, LAN = '127.0.0.1', '192.168.1.5'

ALLOWED = [
    # own names, Host, Origin, address reached
    (LOOPBACK, 'localhost:8080', None, HERE),
    (LOOPBACK, 'localhost:8080', 'http://localhost:8080', HERE),
    (LOOPBACK, 'LOCALHOST:8080', 'http://localhost:8080', HERE),
    (LOOPBACK, '127.0.0.1:8080', 'http://127.0.0.1:8080', HERE),
    (LOOPBACK, '[::1]:8080', 'http://[::1]:8080', HERE),
    (LOOPBACK, 'localhost:9000', 'http://localhost:9000', HERE),
    (LOOPBACK, 'localhost', 'http://localhost', HERE),
    (LOOPBACK, 'localhost:443', 'https://localhost', HERE),
    (OwnHosts('lab-pc'), 'lab-pc:8080', 'http://lab-pc:8080', LAN),
    (OwnHosts('Lab-PC'), 'lab-pc:8080', 'http://lab-pc:8080', LAN),
    (OwnHosts('lab-pc'), f'{LAN}:8080', f'http://{LAN}:8080', LAN),
    (NAMED, 'robots.example', 'https://robots.example', HERE),
    (NAMED, 'robots.example:81', 'http://robots.example:81', HERE),
    (NAMED, 'lab:9000', 'http://lab:9000', HERE),
    (NETWORK, f'{LAN}:8080', f'http://{LAN}:8080', LAN),
    (NETWORK, f'{socket.gethostname()}:8080', f'http://{socket.gethostname().lower()}:8080', LAN),
    (NETWORK, '0.0.0.0:8080', 'http://0.0.0.0:8080', HERE),
    (OwnHosts('::'), '[fd00::5]:8080', 'http://[fd00::5]:8080', 'fd00::5'),
]
REFUSED = [
    # other pages
    (LOOPBACK, 'localhost:8080', 'http://evil.example', HERE),
    (LOOPBACK, 'localhost:8080', 'http://localhost:3000', HERE),
    (LOOPBACK, 'localhost:8080', 'http://localhost', HERE),
    (LOOPBACK, 'localhost:8080', 'http://127.0.0.1:8080', HERE),
    (LOOPBACK, 'localhost:8080', 'http://localhost:8080.evil.example', HERE),
    (LOOPBACK, 'localhost:8080', 'http://evil.example/localhost:8080', HERE),
    (LOOPBACK, 'localhost:8080', 'http://user@localhost:8080', HERE),
    (LOOPBACK, 'localhost:8080', 'null', HERE),
    (LOOPBACK, 'localhost:8080', '', HERE),
    (LOOPBACK, 'localhost:8080', 'file://', HERE),
    (LOOPBACK, 'localhost:8080', 'chrome-extension://localhost:8080', HERE),
    (LOOPBACK, 'localhost:8080', 'localhost:8080', HERE),
    (LOOPBACK, 'localhost:80', 'https://localhost', HERE),
    (NAMED, 'localhost:8080', 'http://robots.example', HERE),
    (NETWORK, f'{LAN}:8080', 'http://evil.example', LAN),
    (NETWORK, '0.0.0.0:8080', 'http://evil.example', HERE),
    # names that lead here
    (LOOPBACK, 'evil.example:8080', 'http://evil.example:8080', HERE),
    (LOOPBACK, 'evil.example:8080', None, HERE),
    (LOOPBACK, 'localhost.evil.example:8080', None, HERE),
    (LOOPBACK, 'evil.example', 'http://localhost:8080', HERE),
    (LOOPBACK, f'{LAN}:8080', f'http://{LAN}:8080', HERE),
    (LOOPBACK, socket.gethostname() + '.evil:8080', None, HERE),
    (NAMED, 'lab:9001', 'http://lab:9001', HERE),
    (NAMED, 'lab', 'http://lab', HERE),
    (NAMED, 'x.robots.example', None, HERE),
    (NETWORK, '192.168.1.6:8080', None, LAN),
    # what is not a host
    (LOOPBACK, '', None, HERE),
    (LOOPBACK, 'localhost:8080, evil.example', None, HERE),
    (LOOPBACK, 'localhost:0', None, HERE),
    (LOOPBACK, 'localhost:99999', None, HERE),
    (LOOPBACK, 'localhost:', None, HERE),
    (LOOPBACK, 'evil.example@localhost:8080', None, HERE),
    (LOOPBACK, 'localhost:8080/', None, HERE),
    (LOOPBACK, 'localhost\n:8080', None, HERE),
    (LOOPBACK, '::1', None, HERE),
]


def objection(own, host, origin, reached):
    """Return what is said against a connection with these headers."""
    return own.objection([host], [] if origin is None else [origin], reached)


@pytest.mark.parametrize('own, host, origin, reached', ALLOWED)
def test_the_page_gets_in_by_each_of_its_names(own, host, origin, reached):
    """With any port, which a forwarded port changes."""
    assert objection(own, host, origin, reached) is None


@pytest.mark.parametrize('own, host, origin, reached', REFUSED)
def test_others_do_not(own, host, origin, reached):
    """Other pages, and names that somebody bends to this machine."""
    assert objection(own, host, origin, reached)


def test_headers_that_come_twice_or_not_at_all_are_not_the_pages():
    """Who reads the first would let in the second. Only Origin may be missing."""
    host, origin = 'localhost:8080', 'http://localhost:8080'
    assert LOOPBACK.objection([host], [origin], HERE) is None
    assert LOOPBACK.objection([], [], HERE)
    assert LOOPBACK.objection([host, host], [origin], HERE)
    assert LOOPBACK.objection([host, 'evil.example'], [], HERE)
    assert LOOPBACK.objection([host], [origin, origin], HERE)


def test_an_objection_names_who_came():
    """So that whoever uses a proxy sees what to allow."""
    assert '"evil.example:8080"' in objection(LOOPBACK, 'evil.example:8080', None, HERE)
    assert '"http://evil.example"' in objection(LOOPBACK, 'localhost', 'http://evil.example', HERE)
    assert len(objection(LOOPBACK, 'x' * 8000, 'y' * 8000, HERE)) < 200


@pytest.mark.parametrize('host, url', [
    ('localhost', 'http://localhost:8080'), ('lab-pc', 'http://lab-pc:8080'),
    ('0.0.0.0', 'http://localhost:8080'), ('::', 'http://localhost:8080')])
def test_the_page_is_opened_by_a_name_that_browsers_find(host, url):
    """0.0.0.0 is an address to listen on; not every browser takes it for this machine."""
    assert Address(host, host, 8080, None).url == url


@pytest.mark.parametrize('text, hosts', [
    ('', ()), (' , ', ()), ('lab', (Host('lab', None),)), ('LAB:80', (Host('lab', 80),)),
    ('a, b:1 c_d.e', (Host('a', None), Host('b', 1), Host('c_d.e', None))),
    ('[::1]:8080,[fe80::1]', (Host('::1', 8080), Host('fe80::1', None)))])
def test_names_are_separated_by_commas_or_spaces(text, hosts):
    """In ~allowed_hosts."""
    assert parse_hosts(text) == hosts


@given(st.text())
def test_any_text_is_a_host_or_none(text):
    """Headers are made up by strangers."""
    host = parse_host(text)
    assert host is None or (host.name and (host.port is None or 1 <= host.port <= 65535))
    LOOPBACK.objection([text], [text], HERE)
