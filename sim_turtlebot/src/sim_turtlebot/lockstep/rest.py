"""Rest: a moment at which every thread of some processes sleeps, as /proc shows it.

A thread that was seen asleep, and has not run since, can only sleep or wait for a processor. If that
holds for all threads, and a look then finds each asleep, nobody is left to wake another: over
loopback, a message is there when the sender's write returns.

Only a thread that polls may still have something to do: rospy.wait_for_message(), ros::Rate and
ros::Timer nap by wall time, and then look. If another thread of its process has run, it has to look
once more when all others rest.
"""

import contextlib
import errno
import os
import time

from sim_turtlebot.lockstep.processes import Process

LONGEST_POLL = 0.025  # s; rospy.wait_for_message() polls every 10 ms, roscpp every millisecond
PATIENCE = 2.0  # s of CPU time that a process may use before it rests
BUSY_SHARE = 0.1  # of that, which a main thread uses that is to blame; rospy.spin() uses nothing
STOP_PATIENCE = 2.0  # s of wall time for a process that a signal or a debugger has stopped
STALL_TIMEOUT = 60.0  # s of wall time, for what neither computes nor sleeps
SPIN_TIME = 0.001  # s of wall time
LOOK_PERIOD = 2e-5  # s of wall time, after that


class Rest:
    """Waits until some processes rest at once."""

    def __init__(self, is_over, on_restless, is_flooded=lambda process: False):
        """Begin with no process.

        :param is_over: function that returns whether to wait no longer
        :param on_restless: function of a Process that does not come to rest, and is not awaited any
            more
        :param is_flooded: function of a Process that returns whether such a one keeps it awake
        """
        self._is_over, self._on_restless, self._is_flooded = is_over, on_restless, is_flooded
        self.processes = {}  # by id
        self.rested = {}  # by Process: the usage of its threads that do not nap, when all rested last
        self._awaited = []
        self.stopped = set()  # Processes that are not awaited until they continue

    def add(self, name, pid, longest_poll=LONGEST_POLL, patience=PATIENCE):
        """Wait for one more process; parameters and errors are those of Process."""
        self.processes[pid] = Process(name, pid, longest_poll, patience)
        self._awaited.append(self.processes[pid])

    def wait(self, only_clock=False):
        """Return when all rest at once, but for those that have been waited for long enough.

        :param only_clock: whether the processes received only a tick of the clock, each on one thread
        """
        begin, first_cpu_times, rested, polls = time.monotonic(), {}, None, {}
        while not self._is_over():
            look_begin = time.monotonic()
            try:
                self._await_continued()
                # Before the look: a thread that sleeps later may have been given work in between.
                polls = {thread: sleeps for thread, sleeps in polls.items() if thread.sleeps < sleeps}
                restless = self._look()
                if not restless:
                    before, (rested, polling) = rested, self._split(look_begin, int(only_clock))
                    polls = {thread: polls.get(thread, looks) for thread, looks in polling.items()
                             if thread in polls or self._has_news(thread, rested, before)}
                    if not polls:
                        self.rested = rested
                        return
                    restless = self.processes[next(iter(polls)).pid]
                if look_begin - begin < SPIN_TIME:
                    # These looks may take the processor from those that have something to do.
                    os.sched_yield()
                    continue
                first_cpu_times = first_cpu_times or {
                    thread: thread.usage[0] for process in self._awaited
                    for thread in process.threads.values()}
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
        self.stopped.discard(process)
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
        """If one takes too long, stop waiting for what keeps the graph awake; return whether it does.

        :param process: does not rest
        :param first_cpu_times: CPU time (ns) by Thread, when all began to wait; new ones are added
        :param passed: s of wall time since then
        """
        def spent(thread):
            now = thread.usage[0]
            return (now - first_cpu_times.setdefault(thread, now)) / 1e9

        def spent_by_main(process):
            return sum(spent(thread) for thread in process.threads.values() if thread.tid == process.pid)

        is_stopped = passed > STOP_PATIENCE and process.is_stopped()
        if not is_stopped and (sum(map(spent, process.threads.values())) <= process.patience
                               and passed <= STALL_TIMEOUT):
            return False
        busiest = max((node for node in self._awaited if node.longest_poll), key=spent_by_main, default=None)
        if is_stopped:
            self.stopped.add(process)
        elif busiest and spent_by_main(busiest) > BUSY_SHARE * process.patience:
            process = busiest
        elif not process.longest_poll or self._is_flooded(process):
            # It reads what a node sends without a pause, which is no fault of its own.
            max(process.threads.values(), key=spent).ignored = True
            return True
        self._awaited.remove(process)
        self._on_restless(process)
        return True

    def _await_continued(self):
        continued = {process for process in self.stopped if not process.is_stopped()}
        self.stopped -= continued
        self._awaited += continued

    def _split(self, look_begin, receivers):
        """Tell apart what works and what only polls.

        :param look_begin: when the look began (monotonic, s)
        :param receivers: how many threads of a process may have run without news for those that poll
        :returns: the usage of the threads that work, by Process; and, by thread that polls, how often
            it has slept when it has looked for work once more
        """
        rested, polling = {}, {}
        for process in self._awaited:
            limit, threads = process.longest_poll, process.threads.values()
            for thread in threads if process.is_cpp else ():
                thread.survey()
            rested[process] = {thread: thread.settled for thread in threads
                               if not (thread.naps or thread.polls or thread.ignored)}
            # ros::Rate and ros::Timer poll for the clock.
            if limit and (process.is_cpp or self._count_new(process, rested[process]) > receivers):
                polling.update({thread: thread.sleeps + (1 if thread.is_asleep else 2)
                                for thread in threads if not (
                                    thread in rested[process] or thread.ignored or thread.is_asleep
                                    and thread.naps_longer_than(limit, thread.runs, look_begin))})
        return rested, polling

    def _count_new(self, process, usages):
        """Return how many threads of a process have run since all rested last."""
        earlier = self.rested.get(process, {})
        return sum(earlier.get(thread) != usage for thread, usage in usages.items())

    def _has_news(self, thread, rested, before):
        """Return whether another node, which may have sent something, has run since `before`."""
        return before is None or any(
            process.longest_poll and process.pid != thread.pid and usages != before.get(process)
            for process, usages in rested.items())

    def _forget_ended(self):
        for pid, process in list(self.processes.items()):
            try:
                process.list_threads()
                if pid != os.getpid():  # a thread of this one may have ended just now
                    process.cpu_time()
            except OSError:
                self.remove(pid)
