"""Which processes lockstep finds behind the nodes that the master knows."""

import contextlib
import socket
import sys
import types

import pytest
import rosgraph
from odometry_tests.processes import Process
from sim_turtlebot.lockstep import graph as graph_module
from sim_turtlebot.lockstep.graph import GraphProcesses
from sim_turtlebot.lockstep.idle import IdleWaiter

LINK = '/elsewhere', '/talker', '/listener'
TEST_NET = '192.0.2.1'  # an address of no machine: RFC 5737


@pytest.fixture
def reports():
    return []


@pytest.fixture
def graph(master, reports):
    """Return the IdleWaiter of a graph with this test's node, and its GraphProcesses."""
    waiter = IdleWaiter(lambda process, _: pytest.fail(f'{process.name} is busy'),
                        lambda process: False, 20.0)
    with contextlib.closing(waiter):
        yield waiter, GraphProcesses(waiter, '/graph', lambda *report: reports.append(report))


def register(name, address):
    rosgraph.Master(name).registerPublisher('/elsewhere', 'std_msgs/Empty', address)


def test_a_node_on_another_machine_is_named_once(graph, reports):
    """Nobody there can be looked at; one at a free port of this machine has ended."""
    _, processes = graph
    with socket.socket() as free:
        free.bind(('localhost', 0))
        port = free.getsockname()[1]
    register('/far', f'http://{TEST_NET}:1')
    register('/dead', f'http://localhost:{port}')
    processes.wait()
    processes.wait()
    assert reports == [('/far', graph_module.UNSEEN)]


def test_the_master_has_told_everybody_of_a_node_that_was_started_again(graph, monkeypatch):
    """It has the name and the topics of one that was killed: only its address is new."""
    waiter, processes = graph
    told = []
    monkeypatch.setattr(waiter, 'wait_for_polls', told.append)
    for port in 1, 2:
        register('/again', f'http://{TEST_NET}:{port}')
        told.clear()
        processes.wait()
        assert told


@pytest.mark.parametrize('after, is_refused, is_given_up', [(3, False, False), (1000, False, True), (1000, True, False)])
def test_a_connection_is_given_up_by_the_time_in_which_all_nodes_rest(
        graph, reports, monkeypatch, after, is_refused, is_given_up):
    """A connection that is reported once somebody has asked so often; no clock tells how long that takes.

    Of two types it is never made, which is nobody's delay.
    """
    _, processes = graph
    asked = iter(range(after))

    def missing_links():
        return {LINK} - processes._unconnected if next(asked, None) is not None else set()

    # On a busy machine each wait may take an hour: it must not look at the clock.
    monkeypatch.setattr(graph_module, 'time', types.SimpleNamespace(sleep=lambda _: None))
    monkeypatch.setattr(processes, '_missing_links', missing_links)
    monkeypatch.setattr(graph_module, 'is_refused', lambda *_: is_refused)
    processes.wait()
    processes.wait()
    assert [reason for name, reason in reports if name == LINK[2]] == [
        'has not connected to /talker on /elsewhere for 5 s'] * is_given_up


@pytest.mark.parametrize('program', ['node', 'rviz'])
def test_what_roslaunch_has_started_is_awaited_before_it_is_a_node(graph, tmp_path, program):
    """Else time would begin without it. RViz only shows."""
    waiter, processes = graph
    (tmp_path / program).symlink_to(sys.executable)
    with Process(tmp_path / program, '-c', 'import time; print("up", flush=True); time.sleep(60)',
                 '__name:=late') as late:
        late.wait_for_output('up')
        processes.add_starting()
        assert (late.pid in waiter.processes) == (program != 'rviz')


def test_an_address_that_another_server_has_by_now_is_given_up(graph, reports):
    """That of a node that was killed; the server takes the call, and answers nothing."""
    with socket.create_server(('localhost', 0)) as server:
        address = f'http://localhost:{server.getsockname()[1]}'
        register('/gone', address)
        rosgraph.Master('/listener').registerSubscriber('/elsewhere', 'std_msgs/Empty', address)
        _, processes = graph
        processes.wait()
    assert ('/gone', 'has not answered for 5 s') in reports
