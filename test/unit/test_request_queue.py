"""Whose turn it is to serve requests, and in which order they are served."""

import threading
from contextlib import suppress
from functools import partial

import pytest
from odometry_tests.waiting import TIMEOUT, wait_until
from sim_turtlebot.request_queue import RequestQueue

from sim_turtlebot import request_queue

PATIENCE = 60.0  # s
COUNT = 200  # requests of each thread
WAITS = 200_000  # of a SimpleQueue one in some 40 000 had no end
MAIN = threading.current_thread()


@pytest.fixture
def requests():
    """Return a queue whose turn this thread has."""
    return RequestQueue()


@pytest.fixture
def served():
    """Return a list for the threads that have served a request, and for what follows."""
    return []


def bring(requests, served):
    """Bring a request."""
    requests.serve_if_lent(lambda: served.append(threading.current_thread()),
                           lambda: served.append('then'))


def wait_until_served(requests):
    """Return once nothing is left that would keep the main thread from lending its turn."""
    wait_until(requests.empty, TIMEOUT, 'the main thread to serve what was put', period=0.001)


def run(target, *arguments):
    """Return a thread that is under way."""
    thread = threading.Thread(target=target, args=arguments, daemon=True)
    thread.start()
    return thread


def end(thread):
    """Return once a thread has ended."""
    thread.join(PATIENCE)
    assert not thread.is_alive()


def test_while_the_main_thread_has_the_turn_it_serves(requests, served):
    """Nothing follows then: the main thread knows how to go on."""
    end(run(bring, requests, served))
    assert not served
    assert requests.serve(0.0)
    assert served == [MAIN]
    assert not requests.serve(0.0)


def test_who_is_lent_the_turn_serves_at_once(requests, served):
    """The main thread is left to wait meanwhile."""
    def bring_until_it_is_lent():
        while 'then' not in served:
            bring(requests, served)
            wait_until_served(requests)

    thread = run(bring_until_it_is_lent)
    while thread.is_alive():
        if requests.lend_turn(0.01):
            requests.serve(0.0)
    assert served[-2:] == [thread, 'then']
    assert set(served[:-2]) <= {MAIN}


def test_what_goes_wrong_on_a_lent_turn_is_raised_on_the_main_thread(requests, served):
    """There it ends the node; of what its own threads raise rospy only logs a line."""
    def fail():
        if threading.current_thread() is not MAIN:
            served.append('nothing')
            raise ZeroDivisionError

    def bring_until_it_has_failed():
        with suppress(ZeroDivisionError):
            while not served:
                requests.serve_if_lent(fail, lambda: None)
                wait_until_served(requests)

    thread = run(bring_until_it_has_failed)
    with pytest.raises(ZeroDivisionError):
        while thread.is_alive() or not requests.empty():
            if requests.lend_turn(0.01):
                requests.serve(0.0)
    end(thread)


def test_the_turn_comes_back_with_a_request_or_after_its_time(requests, served):
    """And is nobody else's then."""
    assert not requests.lend_turn(0.0)
    requests.put(lambda: served.append('put'))
    assert requests.lend_turn(PATIENCE)
    end(run(bring, requests, served))
    while requests.serve(0.0):
        pass
    assert served == ['put', MAIN]


def test_no_wait_outlasts_its_time(requests):
    """Not even one that is over before it begins, as where the machine lets its thread stand."""
    def wait_again_and_again():
        for _ in range(WAITS):
            requests.put(lambda: None)
            assert requests.serve(0.0)
            assert not requests.serve(1e-9)
        ended.set()

    ended = threading.Event()
    end(run(wait_again_and_again))
    assert ended.is_set()


def test_a_request_that_nobody_begins_to_serve_in_time_fails_and_never_takes_effect(
        requests, served, monkeypatch):
    """Its caller may have given up by then, and done something else."""
    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    with pytest.raises(TimeoutError, match='not begun within 0.01 s of wall time, and dropped'):
        requests.put_and_wait(lambda: served.append('late'))
    assert requests.serve(0.0)
    assert not served


def test_a_request_that_takes_too_long_fails_and_says_that_it_takes_effect(requests, monkeypatch):
    """What has begun cannot be stopped."""
    begun, failed = threading.Event(), threading.Event()

    def serve_on_another_thread(request):
        run(request)
        assert begun.wait(PATIENCE)

    monkeypatch.setattr(request_queue, 'ANSWER_TIMEOUT', 0.01)
    monkeypatch.setattr(requests, 'put', serve_on_another_thread)
    with pytest.raises(TimeoutError, match='not finished within 0.01 s of wall time; it will'):
        requests.put_and_wait(lambda: begun.set() or failed.wait(PATIENCE))
    failed.set()


def test_no_request_is_lost_or_overtakes_another_one_of_its_thread(requests):
    """However often the turn is lent."""
    served, about_to_lend = [], threading.Semaphore(0)

    def note(*request):
        requests.serve_if_lent(lambda: served.append(request), lambda: None)

    def have_noted(*request):
        if threading.current_thread() is MAIN:
            served.append(request)
        else:  # which has the turn, so that this one has to wait
            note(*request)

    def bring_all(name):
        for number in range(0, COUNT, 2):
            assert about_to_lend.acquire(timeout=PATIENCE)
            requests.serve_if_lent(partial(have_noted, name, number), lambda: None)
            note(name, number + 1)

    threads = [run(bring_all, name) for name in 'ab']
    while any(thread.is_alive() for thread in threads):
        about_to_lend.release()
        if requests.lend_turn(0.01):
            requests.serve(0.0)
    while requests.serve(0.0):
        pass
    for wanted in 'ab':
        assert [number for name, number in served if name == wanted] == list(range(COUNT))
