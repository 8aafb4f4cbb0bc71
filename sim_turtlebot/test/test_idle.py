"""When all threads of some processes sleep, and nobody is left to wake them."""

import contextlib
import os
import subprocess
import sys
import threading
import time

import pytest
from answering_programs import (
    BUSY,
    COMPUTES,
    HAND_OVER,
    LATE_POLLER,
    MANY_THREADS,
    NAPPING_THREAD,
    NAPPING_THREADS,
    READER,
    RING,
    SLOW_POLLER,
)
from odometry_tests.waiting import TIMEOUT, wait_until
from sim_turtlebot.lockstep import budgets
from sim_turtlebot.lockstep.budgets import Budgets
from sim_turtlebot.lockstep.idle import IdleWaiter
from sim_turtlebot.lockstep.processes import Process
from sim_turtlebot.lockstep.threads import Thread

CPU_BUDGET = 2.0  # s


@pytest.fixture
def busy():
    return []


@pytest.fixture
def waiter(busy):
    with contextlib.closing(IdleWaiter(lambda process, _: busy.append(process),
                                       lambda process: False, CPU_BUDGET)) as waiter:
        yield waiter


@pytest.fixture
def start(waiter):
    """Return a function that starts Python code as a process and has it waited for."""
    started = []

    def start(code):
        process = subprocess.Popen([sys.executable, '-c', code], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True, bufsize=1)
        started.append(process)
        waiter.add(code, process.pid)
        return process

    yield start
    for process in started:
        process.kill()
        process.communicate()


def ask(waiter, process, rounds=100):
    """Ask again and again; each time all has been answered once the process rests."""
    answers = []
    reader = threading.Thread(
        target=lambda: [answers.append(int(line)) for line in process.stdout], daemon=True)
    reader.start()
    waiter.add('this process', os.getpid())
    for number in range(rounds):
        process.stdin.write(f'{number}\n')
        waiter.wait()
        assert [*answers] == [*range(1, number + 2)]
        yield


@pytest.mark.parametrize('code', [READER, HAND_OVER, LATE_POLLER, MANY_THREADS, NAPPING_THREADS],
                         ids=['reader', 'hand over', 'late poller', 'many threads', 'napping threads'])
def test_an_idle_process_has_answered(waiter, start, busy, code):
    """Whatever threads the work goes through, in that process and in this one; of those that ended no file is open."""
    files = []
    for _ in ask(waiter, start(code)):
        files.append(len(os.listdir('/proc/self/fd')))
    assert not busy
    assert files[-1] < files[0] + 30  # a thread of each round would have left three


def test_work_that_costs_no_cpu_time_is_waited_for(waiter, start, monkeypatch):
    """A virtual machine that was kept from its processor does not count what runs next on it."""
    monkeypatch.setattr(Process, 'cpu_time', lambda _: 0)
    for _ in ask(waiter, start(RING), 300):
        pass


def test_timers_are_as_late_as_the_checks_on_a_busy_machine(waiter, start, monkeypatch):
    """A thread that polls each 10 ms seems to sleep for long."""
    nap = time.sleep
    monkeypatch.setattr(time, 'sleep', lambda _: nap(0.04))
    for _ in ask(waiter, start(LATE_POLLER), 30):
        pass


def test_a_process_that_never_rests_is_named_and_waited_for_once(waiter, start, busy):
    """After two seconds of computing; not those beside it that wake now and then, whatever the order."""
    for code in SLOW_POLLER, BUSY, SLOW_POLLER:
        start(code)
    begin = time.monotonic()
    waiter.wait()
    assert time.monotonic() - begin >= CPU_BUDGET
    process, = busy
    assert process.name == BUSY
    waiter.wait()
    assert len(busy) == 1


def test_the_process_that_computes_most_is_named_when_nothing_comes_to_rest(waiter, start, monkeypatch):
    """On any thread, and however little; which process a check finds awake is chance."""
    monkeypatch.setattr(budgets, 'STALL_TIMEOUT', 0.1)
    start(SLOW_POLLER)
    culprit = waiter.processes[start(NAPPING_THREAD).pid]
    used = Budgets(waiter.awaited)

    def is_named():
        culprit.list_threads()
        return used.have_stalled() and used.find_busy(None) is culprit

    wait_until(is_named, TIMEOUT, 'the one with the thread')


def test_what_a_process_has_computed_before_is_not_held_against_it(waiter, start, busy):
    """Also if its threads are seen for the first time after others have been waited for."""
    first, veteran = start(COMPUTES.format(0.0, 0.3)), start(COMPUTES.format(2.5, 0.8))
    for process in first, veteran:
        assert process.stdout.readline() == 'ready\n'
    for process in first, veteran:
        process.stdin.write('go\n')
    waiter.wait()
    assert not busy


def test_a_thread_that_always_polls_is_awake_while_it_works(waiter, start):
    """As roscpp's threads, which compute between two polls; one that is ignored is not."""
    child = start('print("ready", flush=True)\n' + BUSY)
    assert child.stdout.readline() == 'ready\n'
    process = waiter.processes[child.pid]
    thread = process.awake_thread()
    thread.always_polls = True
    assert process.awake_thread() is thread
    thread.ignored = True
    assert process.awake_thread() is None


def test_a_thread_of_roscpp_that_sleeps_by_wall_time_may_run_between_two_looks(waiter, start):
    """On a busy machine ros::Rate polls more often than all others can be looked at; not while it waits otherwise."""
    child = start('import select, sys, time\nprint("ready", flush=True)\n'
                  'while not select.select([sys.stdin], [], [], 0)[0]: time.sleep(0.001)\n'
                  'for _ in range(2): sys.stdin.readline()')
    assert child.stdout.readline() == 'ready\n'
    process = waiter.processes[child.pid]
    process.is_cpp = True
    process.list_threads()
    wait_until(process.check_idle, TIMEOUT, 'a thread that sleeps')
    thread, = process.threads.values()
    before = thread.sleep_count
    wait_until(lambda: thread.sleep_count > before, TIMEOUT, 'a poll')
    wait_until(process.check_asleep, TIMEOUT, 'a thread that sleeps')
    assert thread.sleeps_by_wall_time and process.is_still_idle()
    child.stdin.write('go\n')
    wait_until(lambda: process.check_asleep() and not thread.sleeps_by_wall_time, TIMEOUT, 'a thread that reads')
    assert not process.is_still_idle()


def test_a_thread_that_ends_while_its_files_are_opened_leaves_none_open(monkeypatch):
    """Here after two of three."""
    before, left, open_file = os.listdir('/proc/self/fd'), iter(range(2)), os.open

    def open_some(*arguments):
        if next(left, None) is None:
            raise FileNotFoundError
        return open_file(*arguments)

    monkeypatch.setattr(os, 'open', open_some)
    with pytest.raises(FileNotFoundError):
        Thread(os.getpid(), threading.get_native_id())
    assert os.listdir('/proc/self/fd') == before
