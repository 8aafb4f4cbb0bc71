"""The state of a process and its threads, from /proc."""

import contextlib
import os
import threading
import time

from sim_turtlebot.lockstep.threads import STOPPED, Thread

CPP_LIBRARY = 'libroscpp.so'
# Kinds of CPU clocks: CPUCLOCK_SCHED and CPUCLOCK_PERTHREAD_MASK in linux/posix-timers_types.h
OF_PROCESS, OF_THREAD = 2, 6


class Process:
    """A process; of this one, all threads but the one that waits for the others.

    Every query raises OSError once the process, or a thread of it, has ended.
    """

    def __init__(self, name, pid, longest_poll, cpu_budget):
        """Open its folder.

        :param name: for the user
        :param longest_poll: the longest sleep (s) after which its threads may find work; 0: none
        :param cpu_budget: CPU time that it may use before it is idle (s)
        :raises OSError: if it has ended, or belongs to another user
        """
        self.name, self.pid = name, pid
        self.longest_poll, self.cpu_budget = longest_poll, cpu_budget
        self._own_thread = threading.get_native_id() if pid == os.getpid() else None
        with open(f'/proc/{pid}/maps', encoding='utf-8', errors='replace') as maps:
            self.is_cpp = any(CPP_LIBRARY in line for line in maps)
        self._folder = os.open(f'/proc/{pid}/task', os.O_RDONLY)
        self.threads = {}  # by id
        self._idle_cpu_time = None  # its CPU time (ns) when all threads were idle
        self._usage = None  # what usage() returned, until a thread may have run

    def close(self):
        """Close its files."""
        for thread in self.threads.values():
            thread.close()
        os.close(self._folder)

    def cpu_time(self):
        """Return its CPU time (ns)."""
        if self._own_thread:
            return sum(time.clock_gettime_ns(~tid << 3 | OF_THREAD) for tid in self.threads)
        return time.clock_gettime_ns(~self.pid << 3 | OF_PROCESS)

    def check_idle(self):
        """Return whether each thread is idle, except those that may run."""
        cpu_time = self.cpu_time()
        if cpu_time != self._idle_cpu_time:
            self._usage = None
            self._idle_cpu_time = cpu_time if all(
                thread.may_run or thread.check_idle() for thread in self.threads.values()) else None
        return self._idle_cpu_time is not None

    def check_asleep(self):
        """Return whether each thread sleeps, except those that are ignored."""
        return not self.awake_thread()

    def is_still_idle(self):
        """Return whether no thread has run since check_idle(), except those that may.

        By all figures of their usage: a virtual machine that loses its processor may not count the
        CPU time of what runs next.
        """
        for thread in self.threads.values():
            if thread.read_usage() != thread.idle_usage and not thread.may_run:
                self._idle_cpu_time = None
                return False
        return True

    def usage(self):
        """Return the usage of its threads that do not poll, by Thread, when they were last idle."""
        if self._usage is None:
            self._usage = {thread: thread.idle_usage for thread in self.threads.values()
                           if not (thread.may_poll or thread.may_run)}
        return self._usage

    def awake_thread(self):
        """Return a thread that is awake and not ignored, or None.

        One that always polls is asleep between its polls.
        """
        links = os.fstat(self._folder).st_nlink  # two more than there are threads
        if links - 2 != len(self.threads) + bool(self._own_thread):
            self.list_threads()
        for thread in self.threads.values():
            if not thread.check_asleep() and not thread.ignored:
                return thread
        return None

    def is_stopped(self):
        """Return whether a signal or a debugger has stopped it."""
        thread = self.awake_thread()
        return thread is not None and thread.state in STOPPED

    def is_asleep(self):
        """Return whether it sleeps; False, too, if it has ended."""
        with contextlib.suppress(OSError):
            return self.check_asleep()
        return False

    def has_ended(self):
        """Return whether it has ended; list its threads."""
        try:
            self.list_threads()
            if not self._own_thread:  # whose other threads may have ended just now
                self.cpu_time()
        except OSError:
            return True
        return False

    def list_threads(self):
        """Add the threads that have started, and remove those that have ended."""
        self._usage = None
        tids = {int(tid) for tid in os.listdir(self._folder)} - {self._own_thread}
        for tid in self.threads.keys() - tids:
            self.threads.pop(tid).close()
        for tid in tids - self.threads.keys():
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has ended
                self.threads[tid] = Thread(self.pid, tid, self.is_cpp)
