"""In which order requests are served."""

import threading
import types
from concurrent import futures
from functools import partial

import pytest
from sim_turtlebot.requests import RequestQueue

from sim_turtlebot import requests as request_queue

PATIENCE = 60.0  # s


@pytest.fixture
def requests():
    return RequestQueue()


def test_a_request_that_nobody_begins_to_serve_in_time_fails_and_never_takes_effect(
        requests, monkeypatch):
    """Its caller may have given up by then, and done something else."""
    served = []
    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    with pytest.raises(TimeoutError, match='not begun within 0.01 s of wall time, and dropped'):
        requests.call('/a', 's', lambda: served.append('late'))
    requests.serve_all()
    assert not served


def test_a_request_that_takes_too_long_fails_and_says_that_it_takes_effect(requests, monkeypatch):
    begun, failed = threading.Event(), threading.Event()

    def wait_until_begun(answers, timeout):
        assert begun.wait(PATIENCE)
        return futures.wait(answers, timeout)

    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    monkeypatch.setattr(request_queue, 'futures', types.SimpleNamespace(
        Future=futures.Future, wait=wait_until_begun))
    threading.Thread(target=lambda: requests.wait(PATIENCE) and requests.serve_all(), daemon=True).start()
    with pytest.raises(TimeoutError, match='not finished within 0.01 s of wall time; it will'):
        requests.call('/a', 's', lambda: begun.set() or failed.wait(PATIENCE))
    failed.set()


def test_of_a_topic_the_latest_message_of_each_sender_is_served(requests):
    """In the order in which they came, or poses first, and by the senders' names; one on another topic stays."""
    served = []
    requests.put('/a', '/set_pose', partial(served.append, 'pose'))
    for number in range(3):
        for name in '/b', '/a', '/c':
            requests.put(name, '/cmd_vel', partial(served.append, (name, number)))
    arrivals = requests.arrivals
    assert arrivals.keys() == {'/a', '/b', '/c'}
    assert arrivals['/b'] <= arrivals['/a'] <= arrivals['/c']
    requests.serve_all(by_name=True)
    assert served == ['pose', ('/a', 2), ('/b', 2), ('/c', 2)]
    for name in '/b', '/a', '/b':
        requests.put(name, '/cmd_vel', partial(served.append, name))
    requests.serve_all()
    assert served[4:] == ['/a', '/b'] and not requests.wait(0.0)


def test_what_arrives_meanwhile_is_served_next_time(requests):
    requests.put('/a', '/t', lambda: requests.put('/a', '/t', lambda: None))
    requests.serve_all()
    assert requests.wait(0.0)


def test_while_a_call_is_served_messages_are_and_other_calls_wait(requests):
    served = []

    def start_call(*arguments):
        threading.Thread(target=requests.call, args=arguments, daemon=True).start()

    def step():
        start_call('/b', '/reset', lambda: served.append('reset'))
        assert requests.wait(PATIENCE)
        requests.put('/b', '/cmd_vel', lambda: served.append('command'))
        requests.serve_all()
        served.append('step')

    start_call('/a', '/step', step)
    assert requests.wait(PATIENCE)
    requests.serve_all()
    requests.serve_all()
    assert served == ['command', 'step', 'reset']
