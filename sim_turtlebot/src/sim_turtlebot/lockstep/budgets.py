"""Budgets of CPU time: lockstep stops waiting for a process that exceeds its own."""

import time

# s, of this process or the master: only nodes that send without a pause make these compute.
FLOOD_BUDGET = 2.0
BUSY_SHARE = 0.1  # of a budget, for the main thread of a busy node; rospy.spin() uses nothing
STALL_TIMEOUT = 60.0  # s of wall time, for a process that neither computes nor sleeps


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
        used = self._used_by(process)
        if used > process.cpu_budget or time.monotonic() - self._begin - used > STALL_TIMEOUT:
            return process.cpu_budget
        return None

    def find_busy(self, budget):
        """Return the node's Process whose main thread uses most of a budget (s); None if little."""
        nodes = [process for process in self._processes if process.longest_poll]
        busiest = max(nodes, key=self._used_by_main_thread, default=None)
        is_busy = busiest and self._used_by_main_thread(busiest) > BUSY_SHARE * budget
        return busiest if is_busy else None

    def busiest_thread(self, process):
        """Return the Thread of a Process that has used most."""
        return max(process.threads.values(), key=self._used_by_thread)

    def _used_by(self, process):
        return sum(map(self._used_by_thread, process.threads.values()))

    def _used_by_main_thread(self, process):
        return sum(self._used_by_thread(thread) for thread in process.threads.values()
                   if thread.tid == process.pid)

    def _used_by_thread(self, thread):
        now = thread.usage[0]
        return (now - self._first.setdefault(thread, now)) / 1e9
