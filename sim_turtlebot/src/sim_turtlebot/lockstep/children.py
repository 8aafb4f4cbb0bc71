"""Find the child processes of nodes."""

import contextlib
import os
from pathlib import Path

import psutil

from sim_turtlebot.lockstep.threads import MAX_LINE

MAX_ROUNDS = 30  # of new processes, in one wait: other programs may start some all the time
CPU_BUDGET = 10.0  # s of CPU time until a child is idle; it may be a node that starts


class Children:
    """Adds the children of awaited processes to an IdleWaiter.

    Except those in a process group of their own.
    """

    def __init__(self, waiter, add):
        """Find the newest process; there are no children yet.

        :param waiter: sim_turtlebot.lockstep.idle.IdleWaiter
        :param add: adds a process to it, by its node's name, its id and its least CPU budget (s)
        """
        self._waiter, self._add = waiter, add
        self._parents = {}  # ids, by id of the child
        self._loadavg = os.open('/proc/loadavg', os.O_RDONLY)
        self._end_of_pids = int(Path('/proc/sys/kernel/pid_max').read_text(encoding='ascii'))
        self._newest = self._newest_pid()

    def add_of(self, pid):
        """Add the children of a process.

        :raises psutil.Error: if it has ended
        """
        for child in psutil.Process(pid).children():
            self._add_child(self._waiter.processes[pid], child.pid)

    def await_new(self, nodes):
        """Add those that have been started since the last call, and wait until they are idle.

        One that has ended already may have woken its parent.

        :param nodes: ids of the processes that are nodes themselves
        """
        for _ in range(MAX_ROUNDS):
            before, self._newest = self._newest, self._newest_pid()
            if self._newest == before:
                return
            self._remove_independent(nodes)
            known = {*self._parents}
            ended = [pid for pid in self._pids_since(before) if not self._add_new(pid)]
            if not ended and known.issuperset(self._parents):
                return
            self._waiter.wait()

    def _pids_since(self, before):
        """Yield the ids given since `before` was the newest; small ones follow the largest."""
        if self._newest < before:
            yield from range(before + 1, self._end_of_pids)
            before = 0
        yield from range(before + 1, self._newest + 1)

    def _add_new(self, pid):
        """Add a process that has been started, if it is a child; return False if it has ended."""
        if psutil.pid_exists(pid):
            with contextlib.suppress(psutil.NoSuchProcess):
                self._add_child(self._waiter.processes.get(psutil.Process(pid).ppid()), pid)
                return True
        return os.path.exists(f'/proc/{pid}')  # as a thread

    def _newest_pid(self):
        """Return the id of the process or thread that this machine started last."""
        return int(os.pread(self._loadavg, MAX_LINE, 0).split()[-1])

    def _add_child(self, parent, pid):
        if (parent and parent.longest_poll and pid not in self._waiter.processes
                and _are_one_group(pid, parent.pid)):
            self._parents[pid] = parent.pid
            self._add(parent.name, pid, CPU_BUDGET)

    def _remove_independent(self, nodes):
        """Remove those that ended, or moved to a process group of their own and are no nodes."""
        for pid, parent in list(self._parents.items()):
            if not _are_one_group(pid, parent):
                del self._parents[pid]
                if pid in self._waiter.processes and pid not in nodes:
                    self._waiter.remove(pid)


def _are_one_group(*pids):
    try:
        return len({os.getpgid(pid) for pid in pids}) == 1
    except ProcessLookupError:
        return False
