"""What /proc shows of a process and its threads."""

import contextlib
import os
import threading
import time

from sim_turtlebot.lockstep.threads import STOPPED, Thread

CPP_LIBRARY = 'libroscpp.so'
# Kinds of CPU clocks: CPUCLOCK_SCHED and CPUCLOCK_PERTHREAD_MASK in linux/posix-timers_types.h
OF_PROCESS, OF_THREAD = 2, 6


class Process:
    """A process, without the thread that looks if it is this one.

    Whatever asks for its state raises OSError if it, or a thread of it, has ended.
    """

    def __init__(self, name, pid, longest_poll, patience):
        """Open its folder; OSError: it has ended, or may not be seen.

        :param name: for the user
        :param longest_poll: how long the naps are (s) after which its threads may find work; 0: none
        :param patience: how much CPU time it may use before it rests (s)
        """
        self.name, self.pid = name, pid
        self.longest_poll, self.patience = longest_poll, patience
        self._looker = threading.get_native_id() if pid == os.getpid() else None
        with open(f'/proc/{pid}/maps', encoding='utf-8', errors='replace') as maps:
            self.is_cpp = any(CPP_LIBRARY in line for line in maps)
        self._folder = os.open(f'/proc/{pid}/task', os.O_RDONLY)
        self.threads = {}  # by id
        self._settled_at = None  # CPU time

    def close(self):
        """Close its files."""
        for thread in self.threads.values():
            thread.close()
        os.close(self._folder)

    def cpu_time(self):
        """Return its CPU time (ns)."""
        if self._looker:
            return sum(time.clock_gettime_ns(~tid << 3 | OF_THREAD) for tid in self.threads)
        return time.clock_gettime_ns(~self.pid << 3 | OF_PROCESS)

    def settle(self):
        """Return whether each thread has settled; those that poll need not."""
        cpu_time = self.cpu_time()
        if cpu_time != self._settled_at:
            self._settled_at = cpu_time if all(
                thread.is_free or thread.settle() for thread in self.threads.values()) else None
        return self._settled_at is not None

    def is_asleep(self):
        """Return whether no thread is awake."""
        return not self.awake_thread()

    def is_settled(self):
        """Return whether no thread has run since settle(); those that poll may have."""
        if not all(thread.is_free or thread.is_settled() for thread in self.threads.values()):
            self._settled_at = None
        return self._settled_at is not None

    def awake_thread(self):
        """Return a thread that does not sleep, or None; those that poll may be awake."""
        links = os.fstat(self._folder).st_nlink  # two more than there are threads
        if links - 2 != len(self.threads) + bool(self._looker):
            self.list_threads()
        return next((thread for thread in self.threads.values()
                     if not thread.look() and not thread.is_free), None)

    def is_stopped(self):
        """Return whether a signal or a debugger has stopped it."""
        thread = self.awake_thread()
        return thread is not None and thread.state in STOPPED

    def list_threads(self):
        """Take the threads that have begun, and forget those that have ended."""
        tids = {int(tid) for tid in os.listdir(self._folder)} - {self._looker}
        for tid in self.threads.keys() - tids:
            self.threads.pop(tid).close()
        for tid in tids - self.threads.keys():
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has ended
                self.threads[tid] = Thread(self.pid, tid)
