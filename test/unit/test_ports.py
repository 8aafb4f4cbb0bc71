"""Ports are held from their choice to their use."""

import socket

import pytest
from odometry_launch.ports import HeldPort, master_port, page_port


def listen(port):
    """Listen as ROS's and asyncio's servers do."""
    return socket.create_server(('localhost', port))


@pytest.fixture
def held():
    """Hold a port."""
    port = HeldPort(0)
    yield port
    port.close()


def test_who_is_meant_can_listen_on_it(held):
    """While it is held."""
    with listen(held.number) as server:
        assert server.getsockname()[1] == held.number


def test_nobody_else_can_hold_it(held):
    """Nor is it given to who wants any port."""
    with pytest.raises(OSError):
        HeldPort(held.number)
    others = [HeldPort(0) for _ in range(50)]
    assert held.number not in {other.number for other in others}
    for other in others:
        other.close()


def test_a_port_that_is_listened_on_cannot_be_held():
    """By any program."""
    with listen(0) as server, pytest.raises(OSError):
        HeldPort(server.getsockname()[1])


def test_it_can_be_held_again_once_it_is_closed():
    """At once."""
    first = HeldPort(0)
    first.close()
    HeldPort(first.number).close()


def test_the_master_is_where_rostopic_looks_for_it_if_that_is_free(held, monkeypatch):
    """Else somewhere else."""
    monkeypatch.setenv('ROS_MASTER_URI', f'http://localhost:{held.number}')
    other = master_port()
    assert other.number != held.number and not other.is_first_choice
    monkeypatch.setenv('ROS_MASTER_URI', f'http://localhost:{other.number}')
    other.close()
    again = master_port()
    assert again.number == other.number and again.is_first_choice
    again.close()


@pytest.mark.parametrize('address', ['', 'localhost', 'http://localhost', 'http://localhost:',
                                     'http://localhost:none', 'http://localhost:123456', '['])
def test_an_address_without_a_port_means_the_usual_one(address, monkeypatch):
    """Whatever is wrong with it."""
    monkeypatch.setenv('ROS_MASTER_URI', address)
    asked = []
    monkeypatch.setattr('odometry_launch.ports.HeldPort', lambda number: asked.append(number))
    master_port()
    assert asked == [11311]


def test_the_page_takes_the_next_port(held):
    """The first that is free."""
    port = page_port(held.number)
    assert port.number > held.number
    port.close()
