"""In which order requests are served."""

import random
import threading
from functools import partial

import pytest
from sim_turtlebot.request_queue import RequestQueue

from sim_turtlebot import request_queue

PATIENCE = 60.0  # s
COUNT = 200  # requests of each thread
WAITS = 200_000  # of a SimpleQueue one in some 40 000 had no end


@pytest.fixture
def requests():
    return RequestQueue()


def run(target, *arguments):
    thread = threading.Thread(target=target, args=arguments, daemon=True)
    thread.start()
    return thread


def test_no_wait_outlasts_its_time(requests):
    """Not even one that is over before it begins, as where the machine lets its thread stand."""
    waits = []

    def wait_again_and_again():
        for number in range(WAITS):
            requests.put(('', lambda: None))
            assert requests.serve(0.0)
            assert not requests.serve(1e-9)
            waits.append(number)

    thread = run(wait_again_and_again)
    while len(waits) < WAITS:
        before = len(waits)
        thread.join(PATIENCE)
        assert len(waits) > before


def test_a_request_that_nobody_begins_to_serve_in_time_fails_and_never_takes_effect(
        requests, monkeypatch):
    """Its caller may have given up by then, and done something else."""
    served = []
    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    with pytest.raises(TimeoutError, match='not begun within 0.01 s of wall time, and dropped'):
        requests.put_and_wait(lambda: served.append('late'))
    assert requests.serve(0.0)
    assert not served


def test_a_request_that_takes_too_long_fails_and_says_that_it_takes_effect(requests, monkeypatch):
    """What has begun cannot be stopped."""
    begun, failed = threading.Event(), threading.Event()

    def serve_on_another_thread(named):
        run(named[1])
        assert begun.wait(PATIENCE)

    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    monkeypatch.setattr(requests, 'put', serve_on_another_thread)
    with pytest.raises(TimeoutError, match='not finished within 0.01 s of wall time; it will'):
        requests.put_and_wait(lambda: begun.set() or failed.wait(PATIENCE))
    failed.set()


def test_requests_are_served_by_their_senders_names_and_then_as_they_came(requests):
    served = []

    def bring_all(name):
        for number in range(COUNT):
            requests.put((name, partial(served.append, (name, number))))

    names = ['/b', '/a', '/c']
    random.shuffle(names)
    for thread in [run(bring_all, name) for name in names]:
        thread.join(PATIENCE)
    requests.serve_all()
    assert served == [(name, number) for name in sorted(names) for number in range(COUNT)]
