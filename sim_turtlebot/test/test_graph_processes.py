"""Which processes lockstep finds behind the nodes that the master knows."""

import contextlib
import itertools
import socket
import threading
import types
from xmlrpc.server import SimpleXMLRPCServer

import pytest
import rosgraph
from sim_turtlebot.lockstep import graph as graph_module
from sim_turtlebot.lockstep.graph import GraphProcesses
from sim_turtlebot.lockstep.idle import IdleWaiter

TEST_NET = '192.0.2.1'  # an address of no machine: RFC 5737


@pytest.fixture
def unseen():
    return []


@pytest.fixture
def graph(master, unseen):
    """Return the IdleWaiter of a graph with this test's node, and its GraphProcesses."""
    waiter = IdleWaiter(lambda: False, lambda process, _: pytest.fail(f'{process.name} is busy'))
    with contextlib.closing(waiter):
        yield waiter, GraphProcesses(waiter, '/graph', unseen.append)


def test_a_node_on_another_machine_is_named_once(graph, unseen):
    """Nobody there can be looked at; one at a free port of this machine has ended."""
    _, processes = graph
    with socket.socket() as free:
        free.bind(('localhost', 0))
        port = free.getsockname()[1]
    addresses = {'/far': f'http://{TEST_NET}:1', '/dead': f'http://localhost:{port}'}
    masters = {name: rosgraph.Master(name) for name in addresses}
    for name, master in masters.items():
        master.registerPublisher('/elsewhere', 'std_msgs/Empty', addresses[name])
    try:
        processes.wait()
        processes.wait()
        assert unseen == ['/far']
    finally:
        for name, master in masters.items():
            master.unregisterPublisher('/elsewhere', addresses[name])


def test_the_master_has_told_everybody_of_a_node_that_was_started_again(graph, monkeypatch):
    """It has the name and the topics of one that was killed: only its address is new."""
    waiter, processes = graph
    told = []
    monkeypatch.setattr(waiter, 'wait_for_polls', told.append)
    master = rosgraph.Master('/again')
    addresses = [f'http://{TEST_NET}:{port}' for port in (1, 2)]
    for address in addresses:
        master.registerPublisher('/elsewhere', 'std_msgs/Empty', address)
        told.clear()
        processes.wait()
        assert told
    master.unregisterPublisher('/elsewhere', addresses[-1])


@contextlib.contextmanager
def talker_that_is_connected(after):
    """Yield the address of a node that reports a connection to /listener once it was asked so often."""
    answers = itertools.chain([[]] * after, itertools.repeat([['', '/listener', 'o', '', '/elsewhere']]))
    with SimpleXMLRPCServer(('localhost', 0), logRequests=False) as server:
        server.register_function(lambda _: [1, '', next(answers)], 'getBusInfo')
        for call in 'getPublications', 'getSubscriptions':
            server.register_function(lambda _: [1, '', []], call)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f'http://localhost:{server.server_address[1]}'
        server.shutdown()


@pytest.mark.parametrize('after, is_given_up', [(3, False), (1000, True)])
def test_a_connection_is_given_up_by_the_time_in_which_all_nodes_rest(graph, monkeypatch, after, is_given_up):
    """On a busy machine, where each wait until they do takes an hour here, too."""
    waiter, processes = graph
    clock, wait, given_up = types.SimpleNamespace(now=0.0), waiter.wait, []

    def wait_for_an_hour(only_clock=False):
        wait(only_clock)
        clock.now += 3600.0

    monkeypatch.setattr(waiter, 'wait', wait_for_an_hour)
    monkeypatch.setattr(graph_module, 'time', types.SimpleNamespace(monotonic=lambda: clock.now, sleep=lambda _: None))
    monkeypatch.setattr(processes, '_on_unconnected', lambda *link: given_up.append(link))
    talker, listener = rosgraph.Master('/talker'), rosgraph.Master('/listener')
    with talker_that_is_connected(after) as address:
        talker.registerPublisher('/elsewhere', 'std_msgs/Empty', address)
        listener.registerSubscriber('/elsewhere', 'std_msgs/Empty', address)
        processes.wait()
        processes.wait()
        talker.unregisterPublisher('/elsewhere', address)
        listener.unregisterSubscriber('/elsewhere', address)
    assert given_up == [('/elsewhere', '/talker', '/listener')] * is_given_up
