"""Rest: the moments at which every thread of some processes sleeps, as /proc shows them.

If a process uses no CPU time from one look to another, and each of its threads is asleep in
between, none of them has run: at that moment all slept, and nobody was left to wake them. Only a
thread that polls can hold work back while it sleeps: it has to look once after the others rest.
"""

import errno
import os
import threading
import time

PATIENCE = 2.0  # s of wall time, beside what the thread waits for a processor
LONGEST_WAIT = 60.0  # s of wall time, for processes that wake each other without end
BUSY_WAIT = 0.001  # s of wall time
LOOK_PERIOD = 2e-5  # s of wall time, after that
ASLEEP = b'StTZX'  # in the third field of stat
NAPS = b'hrtimer_nanosleep', b'do_select'  # time.sleep(), since Python 3.11 and before
LONGEST_POLL = 0.015  # s; rospy.wait_for_message() polls every 10 ms
LONGEST_CPP_POLL = 0.005  # s; roscpp polls every 1 ms
OFTEN = 5.0  # Hz; rospy.spin() sleeps by wall time too, twice a second
CPP_LIBRARY = 'libroscpp.so'  # its timers poll, too, in waits for a condition
# Kinds of CPU clocks: CPUCLOCK_SCHED and CPUCLOCK_PERTHREAD_MASK in linux/posix-timers_types.h
OF_PROCESS, OF_THREAD = 2, 6
ENDED = errno.ENOENT, errno.ESRCH, errno.EINVAL  # what /proc and the clock say then

_asleep_in = set()  # functions of the kernel in which a thread has been seen asleep


class Thread:
    """A thread of any process."""

    def __init__(self, pid, tid, polls, naps):
        """Begin with a thread of which it is known that it polls, or not, or is not known (None).

        :param naps: functions of the kernel; whoever sleeps there polls
        """
        self.tid = tid
        self._path, self._files = f'/proc/{pid}/task/{tid}', {}
        self._wchan = None  # the function of the kernel in which it sleeps
        self.polls, self._polls_in = polls, naps
        self._naps = None  # when it last was found to sleep by wall time, and how often it had run

    def close(self):
        """Close its files."""
        for file in self._files.values():
            os.close(file)

    def sleeps(self):
        """Return whether it is asleep; OSError: it has ended."""
        wchan = self._read('wchan')
        if wchan not in _asleep_in:
            state = self._read('stat').rpartition(b')')[2][1]
            if state not in ASLEEP:
                return False
            if wchan == b'0':  # this kernel does not tell, or not now
                return True
            _asleep_in.add(wchan)
        if wchan != self._wchan:
            if wchan in self._polls_in or self._wchan in self._polls_in:
                self.polls = wchan in self._polls_in
            self._wchan = wchan
        return True

    def usage(self):
        """Return how long it ran, how long it waited for a processor (ns), and how often it ran."""
        return tuple(map(int, self._read('schedstat').split()))

    def naps_of_its_own(self, now):
        """Return whether, since the last call, it has slept by wall time again and again."""
        before, self._naps = self._naps, None
        if self._wchan in NAPS and not self.polls:
            self._naps = now, self.usage()[2]
        if not (before and self._naps):
            return False
        return self._naps[1] - before[1] > OFTEN * (now - before[0])

    @property
    def name(self):
        """What its process calls it."""
        return self._read('comm').decode(errors='replace').strip()

    def _read(self, name):
        if name not in self._files:
            self._files[name] = os.open(f'{self._path}/{name}', os.O_RDONLY)
        return os.pread(self._files[name], 512, 0)


class Process:
    """A process, without the thread that looks if it is this one."""

    def __init__(self, name, pid, may_poll=True):
        """Open what is known of it; OSError: it has ended, or may not be seen.

        :param name: for the user
        :param may_poll: whether a thread of it may hold work back while it sleeps by wall time
        """
        self.name, self.pid = name, pid
        self._looker = threading.get_native_id() if pid == os.getpid() else None
        with open(f'/proc/{pid}/maps', encoding='utf-8', errors='replace') as maps:
            self._is_cpp = any(CPP_LIBRARY in line for line in maps)
        self.may_poll = may_poll and not self._looker
        self._folder = os.open(f'/proc/{pid}/task', os.O_RDONLY)
        self._clock = ~pid << 3 | OF_PROCESS
        self.threads, self._clocks = {}, []
        self._settling = None, 0.0, {}

    def close(self):
        """Close its files."""
        for thread in self.threads.values():
            thread.close()
        os.close(self._folder)

    def sample(self):
        """Return the CPU time (ns) used by those that do not poll, and the usage of those that do.

        :raises OSError: if it, or one of them, has ended
        """
        if self._looker:
            return [time.clock_gettime_ns(clock) for clock in self._clocks], {}
        usages = {thread: thread.usage() for thread in self.threads.values()
                  if thread.polls is not False}
        return time.clock_gettime_ns(self._clock) - sum(ran for ran, _, _ in usages.values()), usages

    def awake(self):
        """Return a thread that does not sleep, or None; OSError: one has ended."""
        links = os.fstat(self._folder).st_nlink  # two more than there are threads
        if links - 2 != len(self.threads) + bool(self._looker):
            self.list_threads()
        return next((thread for thread in self.threads.values() if not thread.sleeps()), None)

    def unsettled(self, others, usages):
        """Return a thread that polls and has not looked since the others ran, or None.

        :param others, usages: from sample(), before all were seen asleep
        """
        now = time.monotonic()
        if others != self._settling[0]:
            self._settling = others, now, usages
        _, since, before = self._settling
        for thread, usage in usages.items():
            if usage == before.get(thread):
                thread.polls = now - since < LONGEST_POLL
                return thread
        return None

    def delay(self):
        """Return how long its threads have waited for a processor (s); OSError: one has ended."""
        return sum(thread.usage()[1] for thread in self.threads.values()) / 1e9

    def list_threads(self):
        """Forget the threads that have ended, and take the new ones."""
        tids = {int(tid) for tid in os.listdir(self._folder)} - {self._looker}
        for tid in self.threads.keys() - tids:
            self.threads.pop(tid).close()
        for tid in tids - self.threads.keys():
            self.threads[tid] = Thread(self.pid, tid, None if self._is_cpp else False,
                                       NAPS if self.may_poll else ())
        if self._looker:
            self._clocks = [~tid << 3 | OF_THREAD for tid in self.threads]


class Rest:
    """Waits until a number of processes rest at once."""

    def __init__(self, is_over, on_restless):
        """Begin with no process.

        :param is_over: function that tells whether to wait no longer
        :param on_restless: function of a Process that has not rested for PATIENCE, and is waited for
            no longer, and of one of its Threads
        """
        self._is_over, self._on_restless = is_over, on_restless
        self.processes = {}  # by pid
        self._awaited = []
        self._quiet = None, None, {}, 0.0

    def add(self, name, pid, may_poll=True):
        """Wait for one more process; parameters and errors are those of a Process."""
        self.processes[pid] = Process(name, pid, may_poll)
        self._awaited.append(self.processes[pid])

    def remove(self, pid):
        """Do not wait for a process any more."""
        process = self.processes.pop(pid)
        process.close()
        if process in self._awaited:
            self._awaited.remove(process)

    def wait(self):
        """Return once all rest at once, but for those that have been waited for long enough."""
        begin = since = time.monotonic()
        blamed = delay = None
        while not self._is_over():
            try:
                process, thread = self._restless()
                if not process:
                    return
                now = time.monotonic()
                if process is not blamed:
                    # In front it is looked at first: whoever is blamed next, this one rests then.
                    self._awaited.remove(process)
                    self._awaited.insert(0, process)
                    blamed, since, delay = process, now, None
                restless = now - since
                if restless > PATIENCE / 2:
                    delay = process.delay() if delay is None else delay
                    restless -= process.delay() - delay
            except OSError as error:
                if error.errno not in ENDED:
                    raise
                self._forget_the_ended()
                continue
            if restless > PATIENCE or now - begin > LONGEST_WAIT:
                self._awaited.remove(process)
                self._on_restless(process, thread)
                begin = now
            # The processor that these looks take may be the one that it needs.
            if now - begin < BUSY_WAIT:
                os.sched_yield()
            else:
                time.sleep(LOOK_PERIOD)

    def _restless(self):
        """Return a Process that does not rest and a Thread of it, or None twice."""
        before = [(process, *process.sample()) for process in self._awaited]
        for process in self._awaited:
            if thread := process.awake():
                return process, thread
        for process, others, _ in before:
            if process.sample()[0] != others:
                return process, next(iter(process.threads.values()))
        for process, others, usages in before:
            if thread := self._unknown(before, usages) or process.unsettled(others, usages):
                return process, thread
        return None, None

    def _unknown(self, samples, usages):
        """Return a thread of which it is not known whether it polls, or None.

        It does if it runs while nobody else does.
        """
        unknown = [thread for thread in usages if thread.polls is None]
        if not unknown:
            return None
        now = time.monotonic()
        others = [others for process, others, _ in samples if process.may_poll]
        if (others, unknown) != self._quiet[:2]:
            self._quiet = others, unknown, usages, now
        _, _, before, since = self._quiet
        if now - since > LONGEST_CPP_POLL:
            for thread in unknown:
                thread.polls = usages[thread] != before[thread]
        return unknown[0]

    def _forget_the_ended(self):
        for pid, process in list(self.processes.items()):
            try:
                process.sample()
                process.list_threads()
            except OSError:
                self.remove(pid)
