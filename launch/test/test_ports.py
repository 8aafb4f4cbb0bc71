"""Ports are held from their choice to their use."""

import socket

import pytest
from odometry_launch.ports import HeldPort, next_port, usual_master_port


def listen(port):
    return socket.create_server(('localhost', port))


def test_a_held_port_is_given_to_nobody_else():
    """But its server can listen on it; after close() it is free at once."""
    held = HeldPort(0)
    with pytest.raises(OSError):
        HeldPort(held.number)
    following = next_port(held.number)
    assert following.number > held.number
    following.close()
    listen(held.number).close()
    held.close()
    HeldPort(held.number).close()


def test_a_port_with_a_server_cannot_be_held():
    with listen(0) as server, pytest.raises(OSError):
        HeldPort(server.getsockname()[1])


@pytest.mark.parametrize('address, port', [
    ('http://localhost:1234', 1234), ('', 11311), ('localhost', 11311), ('[', 11311),
    ('http://localhost:none', 11311), ('http://localhost:123456', 11311)])
def test_the_master_goes_where_rostopic_looks_for_it(address, port, monkeypatch):
    monkeypatch.setenv('ROS_MASTER_URI', address)
    assert usual_master_port() == port
