"""Wait for a moment at which every thread of some processes sleeps, as /proc shows it.

A thread that was seen asleep and has not run since either sleeps or waits for a processor. If that
holds for all threads, and the next check finds each asleep, no thread is left to wake another: over
loopback, a message has arrived when the sender's write returns.

Only a thread that polls may still have work: rospy.wait_for_message(), ros::Rate and ros::Timer
sleep by wall time, and then check. If another thread of its process has run, it has to poll once
more when all others are idle.
"""

import contextlib
import errno
import os
import time

from rospy.core import is_shutdown_requested

from sim_turtlebot.lockstep.budgets import STALL_TIMEOUT, Budgets
from sim_turtlebot.lockstep.polls import classify, has_news
from sim_turtlebot.lockstep.processes import Process

LONGEST_POLL = 0.025  # s; rospy.wait_for_message() polls every 10 ms, roscpp every millisecond
STOPPED_TIMEOUT = 2.0  # s of wall time for a process that a signal or a debugger has stopped
SPIN_TIME = 0.001  # s of wall time
# After that, sleeps between two checks: a share of the wait so far, so that on a busy machine the
# checks leave the processor to the nodes; and at most so long (s of wall time).
SLEEP_SHARE, LONGEST_SLEEP = 0.1, 0.001
# On a busy machine a check may come late, and so may a timer: a sleep counts as longer than a poll
# only if it is also longer than so many times the time between two checks.
LATENESS = 3
BUDGET_PERIOD = 0.02  # s of wall time between looks at the budgets; one takes as long as a check
# In a row: a busy machine may leave no other time between two naps of threads that wake in vain.
CHECKS = 3


class IdleWaiter:
    """Waits until all processes are idle at once."""

    def __init__(self, on_busy, is_flooded, cpu_budget):
        """Start without processes.

        :param on_busy: called with a Process that is not awaited any more, and the CPU budget (s)
            that has been exceeded; None after STALL_TIMEOUT
        :param is_flooded: function that returns whether such a busy process keeps a Process awake
        :param cpu_budget: CPU time (s) that a node may use before it is idle
        """
        self._on_busy, self._is_flooded, self.cpu_budget = on_busy, is_flooded, cpu_budget
        self.processes = {}  # by id
        # By Process: the usage of its threads that do not poll, when all were last idle
        self.idle_usage = {}
        self.awaited = []  # those that have not exceeded their budget
        self.stopped = set()  # Processes that are not awaited until they continue
        self._last_check = 0.0  # when it began (monotonic, s)

    def add(self, name, pid, longest_poll=LONGEST_POLL, least_budget=0.0):
        """Wait for one more process; parameters and errors are those of Process.

        :param least_budget: CPU time (s) that it may use even if a node may use less
        """
        budget = max(least_budget, self.cpu_budget)
        self.processes[pid] = Process(name, pid, longest_poll, budget)
        self.awaited.append(self.processes[pid])

    def wait(self, only_clock=False):
        """Return when all processes are idle, except those that have exceeded their budget.

        :param only_clock: whether the processes received only a tick of the clock, each on one
            thread
        """
        begin, budgets, usage, polls = time.monotonic(), None, None, {}
        next_look = begin + BUDGET_PERIOD
        while not is_shutdown_requested():
            check_begin = time.monotonic()
            lateness = LATENESS * (check_begin - self._last_check)
            self._last_check = check_begin
            try:
                self._await_continued()
                # Before the check: a thread that sleeps later may have received work in between.
                polls = {thread: sleeps for thread, sleeps in polls.items()
                         if thread.sleep_count < sleeps}
                busy = self._find_busy()
                if not busy:
                    before = usage
                    usage, polling = classify(self.awaited, self.idle_usage, check_begin,
                                              int(only_clock), lateness)
                    polls = {thread: polls.get(thread, sleeps) for thread, sleeps in polling.items()
                             if thread in polls or has_news(thread, usage, before)}
                    if not polls:
                        self.idle_usage = usage
                        return
                    busy = self.processes[next(iter(polls)).pid]
                if check_begin - begin < SPIN_TIME:
                    # These checks may take the processor from those that have work.
                    os.sched_yield()
                    continue
                if check_begin >= next_look:
                    next_look = check_begin + BUDGET_PERIOD
                    budgets = budgets or Budgets(self.awaited)
                    if self._gives_up(busy, budgets, check_begin - begin):
                        begin, budgets = check_begin, None
            except OSError as error:
                if error.errno == errno.EMFILE:
                    raise
                self._remove_ended()
                usage, polls = None, {}
                continue
            time.sleep(min(LONGEST_SLEEP, SLEEP_SHARE * (check_begin - begin)))

    def wait_for_polls(self, pid):
        """Return when each thread of a process that polls by wall time has polled once more."""
        begin, polling = time.monotonic(), {}
        with contextlib.suppress(OSError, KeyError):  # it has ended
            polling = {thread: thread.sleep_count for thread in self.processes[pid].threads.values()
                       if thread.may_poll}
            while (polling and not is_shutdown_requested()
                   and time.monotonic() - begin < STALL_TIMEOUT):
                time.sleep(LONGEST_POLL)
                polling = {thread: sleeps for thread, sleeps in polling.items()
                           if thread.sleep_count == sleeps}

    def remove(self, pid):
        """Do not wait for a process any more."""
        process = self.processes.pop(pid)
        process.close()
        self.stopped.discard(process)
        if process in self.awaited:
            self.awaited.remove(process)

    def close(self):
        """Remove all processes."""
        for pid in list(self.processes):
            self.remove(pid)

    def _find_busy(self):
        """Return a Process that is not idle; None as soon as a check finds all of them idle."""
        for _ in range(CHECKS):
            if not (busy := self._check()):
                return None
        return busy

    def _check(self):
        """Return a Process that is not idle, or None."""
        for is_idle in Process.check_idle, Process.check_asleep, Process.is_still_idle:
            for process in self.awaited:
                if not is_idle(process):
                    # The next check begins with it, and is short while it is awake.
                    self.awaited.remove(process)
                    self.awaited.insert(0, process)
                    return process
        return None

    def _gives_up(self, process, budgets, passed):
        """If a process exceeds its budget, stop waiting for the busiest; return True.

        :param process: is not idle
        :param budgets: Budgets since the start of the wait
        :param passed: s of wall time since then
        """
        if passed > STOPPED_TIMEOUT and process.is_stopped():
            self.stopped.add(process)
            self._leave(process, process.cpu_budget)
            return True
        budget = budgets.exceeded_by(process)
        if budget is None and not budgets.have_stalled():
            return False
        if busiest := budgets.find_busy(budget):
            self._leave(busiest, budget)
        elif not process.longest_poll or self._is_flooded(process):
            # It reads what another node sends without a pause: the fault is not its own.
            budgets.busiest_thread(process).ignored = True
        else:
            self._leave(process, budget)
        return True

    def _leave(self, process, budget):
        self.awaited.remove(process)
        self._on_busy(process, budget)

    def _await_continued(self):
        continued = {process for process in self.stopped if not process.is_stopped()}
        self.stopped -= continued
        self.awaited += continued

    def _remove_ended(self):
        for pid, process in list(self.processes.items()):
            if process.has_ended():
                self.remove(pid)
