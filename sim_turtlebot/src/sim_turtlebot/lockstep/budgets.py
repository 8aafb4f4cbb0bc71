"""Budgets of CPU time: lockstep stops waiting for a process that exceeds its own."""

import time

# s, of this process or the master: only nodes that send without a pause make these compute.
FLOOD_BUDGET = 2.0
BUSY_SHARE = 0.1  # of a budget, for a busy node; the main thread in rospy.spin() uses nothing
STALL_TIMEOUT = 60.0  # s of wall time in which no node computes, and one does not sleep


class Budgets:
    """The CPU time that processes have used since a moment, and may use."""

    def __init__(self, processes):
        """Begin now; for threads that start later, when they are asked for first."""
        self._processes = processes
        self._begin = time.monotonic()
        self._first = {}  # CPU time (ns) by Thread
        for process in processes:
            self._used_by(process)

    def exceeded_by(self, process):
        """Return the budget (s) that a Process has exceeded, or None."""
        if any(self._used_by(other) > FLOOD_BUDGET
               for other in self._processes if not other.longest_poll):
            return FLOOD_BUDGET
        return process.cpu_budget if self._used_by(process) > process.cpu_budget else None

    def have_stalled(self):
        """Return whether STALL_TIMEOUT has passed, not counting what the nodes have used."""
        used = sum(map(self._used_by, self._nodes))
        return time.monotonic() - self._begin - used > STALL_TIMEOUT

    def find_busy(self, budget):
        """Return the node's Process that has used most; None if that is little.

        :param budget: (s) that has been exceeded: main threads count; None: after a stall all do
        """
        used = self._used_by_main_thread if budget else self._used_by
        busiest = max(self._nodes, key=used, default=None)
        is_busy = busiest and used(busiest) > BUSY_SHARE * (budget or STALL_TIMEOUT)
        return busiest if is_busy else None

    def busiest_thread(self, process):
        """Return the Thread of a Process that has used most."""
        return max(process.threads.values(), key=self._used_by_thread)

    @property
    def _nodes(self):
        return [process for process in self._processes if process.longest_poll]

    def _used_by(self, process):
        return sum(map(self._used_by_thread, process.threads.values()))

    def _used_by_main_thread(self, process):
        return sum(self._used_by_thread(thread) for thread in process.threads.values()
                   if thread.tid == process.pid)

    def _used_by_thread(self, thread):
        now = thread.usage[0]
        return (now - self._first.setdefault(thread, now)) / 1e9
