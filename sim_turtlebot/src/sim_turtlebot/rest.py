"""Rest: a moment at which every thread of some processes sleeps, as /proc shows it.

A thread that was seen asleep, and has not run since, can only sleep or wait for a processor. If that
holds for all threads, and a look then finds each asleep, nobody is left to wake another: over
loopback, a message is there when the sender's write returns.

Only a thread that polls may still have something to do: rospy.wait_for_message(), ros::Rate and
ros::Timer nap by wall time, and then look. It has to have looked since all others rest.
"""

import contextlib
import errno
import os
import time

from sim_turtlebot.processes import Process

LONGEST_POLL = 0.025  # s; rospy.wait_for_message() polls every 10 ms, roscpp every millisecond
PATIENCE = 2.0  # s of CPU time that a process may use before it rests
STALL_TIMEOUT = 60.0  # s of wall time, for what neither computes nor sleeps
SURVEY_TIME = 0.05  # s of wall time in which a thread did not wait for a processor
POLL_RUNS = 20  # in that time, without work; ros::Rate and ros::Timer poll every millisecond
SPIN_TIME = 0.001  # s of wall time
LOOK_PERIOD = 2e-5  # s of wall time, after that


class Rest:
    """Waits until some processes rest at once."""

    def __init__(self, is_over, on_restless):
        """Begin with no process.

        :param is_over: function that returns whether to wait no longer
        :param on_restless: function of a Process that does not come to rest, and is not awaited any
            more
        """
        self._is_over, self._on_restless = is_over, on_restless
        self.processes = {}  # by id
        self.rested = {}  # the usage of threads when all rested last; of those that do not nap
        self._awaited = []
        self._surveyed = set()  # threads of which it is known whether they poll

    def add(self, name, pid, longest_poll=LONGEST_POLL, patience=PATIENCE):
        """Wait for one more process; parameters and errors are those of Process."""
        self.processes[pid] = Process(name, pid, longest_poll, patience)
        self._awaited.append(self.processes[pid])

    def wait(self):
        """Return when all rest at once, but for those that have been waited for long enough."""
        begin, first_cpu_times, rested, polls = time.monotonic(), {}, None, {}
        while not self._is_over():
            look_begin = time.monotonic()
            try:
                # Before the look: a thread that sleeps later may have been given work in between.
                polls = {thread: sleeps for thread, sleeps in polls.items() if thread.sleeps < sleeps}
                restless = self._look()
                if not restless:
                    before, (rested, polling) = rested, self._split(look_begin)
                    polls = ({thread: polls[thread] for thread in polls.keys() & polling.keys()}
                             if rested == before else polling)
                    if not polls:
                        self.rested = rested
                        return
                    restless = self.processes[next(iter(polls)).pid]
                if look_begin - begin < SPIN_TIME:
                    # These looks may take the processor from those that have something to do.
                    os.sched_yield()
                    continue
                first_cpu_times = first_cpu_times or {process: process.cpu_time()
                                                      for process in self._awaited}
                if self._gives_up(restless, first_cpu_times, look_begin - begin):
                    begin, first_cpu_times = look_begin, {}
            except OSError as error:
                if error.errno == errno.EMFILE:
                    raise
                self._forget_ended()
                rested, polls = None, {}
                continue
            time.sleep(LOOK_PERIOD)

    def wait_for_naps(self, pid):
        """Return when each thread of a process that naps by wall time has looked for work once more."""
        begin, napping = time.monotonic(), {}
        with contextlib.suppress(OSError, KeyError):  # it has ended
            napping = {thread: thread.sleeps for thread in self.processes[pid].threads.values()
                       if thread.naps}
            while napping and not self._is_over() and time.monotonic() - begin < STALL_TIMEOUT:
                time.sleep(LONGEST_POLL)
                napping = {thread: sleeps for thread, sleeps in napping.items()
                           if thread.sleeps == sleeps}

    def remove(self, pid):
        """Do not wait for a process any more."""
        process = self.processes.pop(pid)
        process.close()
        if process in self._awaited:
            self._awaited.remove(process)

    def close(self):
        """Stop waiting."""
        for pid in list(self.processes):
            self.remove(pid)

    def _look(self):
        """Return a Process that does not rest, or None."""
        for holds in Process.settle, Process.is_asleep, Process.is_settled:
            for process in self._awaited:
                if not holds(process):
                    # The next look begins with it, and is short while it is awake.
                    self._awaited.remove(process)
                    self._awaited.insert(0, process)
                    return process
        return None

    def _gives_up(self, process, first_cpu_times, passed):
        """Await the process that computes most no longer, and return True, if one takes too long.

        :param process: does not rest
        :param first_cpu_times: when all began to wait
        :param passed: s of wall time since then
        """
        def spent(process):
            return (process.cpu_time() - first_cpu_times[process]) / 1e9

        nodes = [process for process in self._awaited if process.longest_poll]
        if not nodes or spent(process) <= process.patience and passed <= STALL_TIMEOUT:
            return False
        # The master computes because a node keeps asking it.
        culprit = process if process in nodes else max(nodes, key=spent)
        self._awaited.remove(culprit)
        self._on_restless(culprit)
        return True

    def _split(self, look_begin):
        """Tell apart what works and what only polls.

        :param look_begin: when the look began (monotonic, s)
        :returns: by thread that works, its usage; and, by thread that polls, how often it has slept
            when it has looked for work once more
        """
        self._survey()
        working, polling = {}, {}
        for process in self._awaited:
            limit = process.longest_poll
            for thread in process.threads.values():
                if not thread.naps and not thread.polls:
                    working[thread] = thread.settled
                elif limit and not (thread.is_asleep and thread.naps_longer_than(
                        limit, thread.usage[2], look_begin)):
                    polling[thread] = thread.sleeps + (1 if thread.is_asleep else 2)
        return working, polling

    def _survey(self):
        """Find out which threads of C++ poll: those that run while all others rest."""
        threads = {thread for process in self._awaited if process.is_cpp
                   for thread in process.threads.values()}
        for thread in threads - self._surveyed:
            thread.polls = _idle_runs(thread) >= POLL_RUNS
        self._surveyed = threads

    def _forget_ended(self):
        for pid, process in list(self.processes.items()):
            try:
                process.list_threads()
                if pid != os.getpid():  # a thread of this one may have ended just now
                    process.cpu_time()
            except OSError:
                self.remove(pid)


def _idle_runs(thread):
    """Return how often a thread runs in SURVEY_TIME while all others rest."""
    begin, (_, waited, runs) = time.monotonic(), thread.usage
    while True:
        time.sleep(SURVEY_TIME)
        _, waited_now, runs_now = thread.usage
        if (runs_now - runs >= POLL_RUNS
                or time.monotonic() - begin - (waited_now - waited) / 1e9 > SURVEY_TIME):
            return runs_now - runs
