"""Rest: a moment at which every thread of some processes sleeps, as /proc shows it.

If a process has the same CPU time before and after a look that finds each of its threads asleep,
none of them has run meanwhile. If that holds for all processes at once, nobody is left to wake
another: over loopback, a message is there when the sender's write returns.

Only a thread that polls may still have something to do: rospy.wait_for_message(), ros::Rate and
ros::Timer nap by wall time, and then look. It has to have looked since all others rest.
"""

import os
import time

from sim_turtlebot.processes import Process

PATIENCE = 2.0  # s of CPU time that a process may use before it rests
STALL_TIMEOUT = 60.0  # s of wall time, for what neither computes nor sleeps
SURVEY_TIME = 0.05  # s of wall time in which a thread did not wait for a processor
SURVEY_RUNS = 5  # in that time, of a thread that polls
SPIN_TIME = 0.001  # s of wall time
LOOK_PERIOD = 2e-5  # s of wall time, after that


class Rest:
    """Waits until some processes rest at once."""

    def __init__(self, is_over, on_restless):
        """Begin with no process.

        :param is_over: function that returns whether to wait no longer
        :param on_restless: function of a Process that does not come to rest and is not awaited any
            more, and of one of its threads that is awake, or None
        """
        self._is_over, self._on_restless = is_over, on_restless
        self.processes = {}  # by id
        self._awaited = []
        self._surveyed = set()  # threads of which it is known whether they poll

    def add(self, name, pid, may_poll=True, patience=PATIENCE):
        """Wait for one more process; parameters and errors are those of Process."""
        self.processes[pid] = Process(name, pid, may_poll, patience)
        self._awaited.append(self.processes[pid])

    def wait(self):
        """Return when all rest at once, but for those that have been waited for long enough."""
        begin, first_cpu_times, others, polling = time.monotonic(), {}, None, {}
        while not self._is_over():
            try:
                look_begin = time.monotonic()
                process, thread, cpu_times = self._look()
                if process:
                    passed = time.monotonic() - begin
                    spent = process.cpu_time() - first_cpu_times.setdefault(process, process.cpu_time())
                    if spent > process.patience * 1e9 or passed > STALL_TIMEOUT:
                        self._awaited.remove(process)
                        self._on_restless(process, thread)
                        begin = time.monotonic()
                else:
                    before = others, polling
                    others, polling = self._split(cpu_times, look_begin)
                    if others == before[0]:
                        polling = {thread: runs for thread, runs in polling.items()
                                   if before[1].get(thread) == runs}
                    if not polling:
                        return
            except OSError:
                self._forget_ended()
                continue
            # These looks may take the processor from those that have something to do.
            if time.monotonic() - begin < SPIN_TIME:
                os.sched_yield()
            else:
                time.sleep(LOOK_PERIOD)

    def remove(self, pid):
        """Do not wait for a process any more."""
        process = self.processes.pop(pid)
        process.close()
        if process in self._awaited:
            self._awaited.remove(process)

    def _look(self):
        """Return a Process that does not rest, a Thread of it that is awake, if any, and CPU times.

        The former two are None if all rest.
        """
        cpu_times = {process: process.cpu_time() for process in self._awaited}
        for process in self._awaited:
            if thread := process.awake_thread():
                # The next look begins with it, and is short while it is awake.
                self._awaited.remove(process)
                self._awaited.insert(0, process)
                return process, thread, cpu_times
        for process, cpu_time in cpu_times.items():
            if process.cpu_time() != cpu_time:
                return process, None, cpu_times
        return None, None, cpu_times

    def _split(self, cpu_times, look_begin):
        """Return the CPU times (ns) without those of naps, and how often the polling have run."""
        self._survey()
        others, polling = dict(cpu_times), {}
        for process in self._awaited:
            for thread in process.threads.values() if process.may_poll else ():
                if thread.naps or thread.polls:
                    cpu_time, _, runs = thread.usage
                    others[process] -= cpu_time
                    if not thread.takes_long_naps(runs, look_begin):
                        polling[thread] = runs
        return others, polling

    def _survey(self):
        """Find out which threads of C++ poll: those that run while all others rest."""
        threads = {thread for process in self._awaited if process.is_cpp and process.may_poll
                   for thread in process.threads.values()}
        for thread in threads - self._surveyed:
            thread.polls = _runs_often(thread)
        self._surveyed = threads

    def _forget_ended(self):
        for pid, process in list(self.processes.items()):
            try:
                process.list_threads()
                process.cpu_time()
            except OSError:
                self.remove(pid)


def _runs_often(thread):
    """Return whether a thread runs again and again."""
    begin, (_, waited, runs) = time.monotonic(), thread.usage
    while True:
        time.sleep(SURVEY_TIME)
        _, waited_now, runs_now = thread.usage
        if runs_now - runs >= SURVEY_RUNS:
            return True
        if time.monotonic() - begin - (waited_now - waited) / 1e9 > SURVEY_TIME:
            return False
