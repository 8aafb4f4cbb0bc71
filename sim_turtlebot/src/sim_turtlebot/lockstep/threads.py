"""The state of a thread, from /proc."""

import contextlib
import os
import time
from functools import partial

# The kernel functions of time.sleep(); Python to 3.10 selects instead, as servers do
SLEEP, SELECT = b'hrtimer_nanosleep', b'do_select'
SLEEPING, STOPPED, ENDED = b'S', b'tT', b'ZX'  # states in /proc/PID/task/TID/stat
NO_FUNCTION = b'0'  # in wchan: the thread runs, or this kernel does not report functions
MAX_LINE = 128  # bytes, of wchan and schedstat; in stat, the state is among the first
SWITCHES = b'\nvoluntary_ctxt_switches:'  # in /proc/PID/task/TID/status
SAMPLE_TIME = 0.05  # s of wall time, not counting the time that a thread waited for a processor
MIN_POLLS = 20  # in SAMPLE_TIME, without work; ros::Rate and ros::Timer poll every millisecond
# So many long sleeps in a row, or one so many times as long as a poll, prove a long sleeper; on a
# busy virtual machine some timers are late.
SURE_SLEEPS, MAX_LATE = 4, 10.0

_wait_functions = set()  # kernel functions in which threads have been seen asleep


class Thread:
    """A thread of any process; every query raises OSError once the thread has ended."""

    def __init__(self, pid, tid, is_cpp=False):
        self.pid, self.tid, self._is_cpp = pid, tid, is_cpp
        self._path, self._function = f'/proc/{pid}/task/{tid}', None
        with contextlib.ExitStack() as opened:  # the thread may end in between
            # Functions, since each check calls them for every thread of the graph.
            self.read_usage, self._read_function, self._read_stat = (
                self._reader(opened, name) for name in ('schedstat', 'wchan', 'stat'))
            self._files = opened.pop_all()
        self.ignored = False  # whether lockstep does not wait for it
        self.always_polls = None  # whether it polls even without work, as timers of roscpp do
        self.is_asleep = False  # at the last check
        self.idle_usage = None  # its usage when it was last seen asleep
        self.sleeps_seen = 0
        self._runs, self._sleep_begin, self._sleep_time, self._sleep_is_long = 0, 0.0, 0.0, False
        self._long_sleeps = SURE_SLEEPS  # in a row; a thread counts as polling once it has polled

    def close(self):
        """Close its files."""
        self._files.close()

    def check_asleep(self):
        """Return whether it sleeps."""
        self._function = self._read_function()
        self.is_asleep = self._function in _wait_functions or self._is_asleep_by_state()
        return self.is_asleep

    def _is_asleep_by_state(self):
        state, has_function = self.state, self._function != NO_FUNCTION
        if state == SLEEPING and has_function:
            _wait_functions.add(self._function)
        # A thread that fell asleep between the two reads is asleep at the next check.
        return state in ENDED or state == SLEEPING and (has_function or not _wait_functions)

    @property
    def state(self):
        """Its state, as in /proc/PID/task/TID/stat."""
        return self._read_stat().rpartition(b')')[2][1:2]

    def check_idle(self):
        """Return whether it sleeps, or has not run since it was last seen asleep."""
        usage = self.read_usage()
        if usage != self.idle_usage:
            if not self.check_asleep():
                return False
            self.idle_usage = usage
        return True

    @property
    def may_run(self):
        """Whether lockstep does not wait until it is idle; ros::Rate polls every millisecond."""
        return self.always_polls or self.ignored or self._is_cpp and self.sleeps_by_wall_time

    @property
    def may_poll(self):
        """Whether, at the last check, it slept by wall time, or selected."""
        return self._function in (SLEEP, SELECT)

    @property
    def sleeps_by_wall_time(self):
        """Whether, at the last check, it slept by wall time."""
        return self._function == SLEEP

    @property
    def usage(self):
        """Its CPU time (ns), how long it waited for a processor (ns), and how often it has run."""
        return tuple(map(int, self.read_usage().split()))

    @property
    def sleep_count(self):
        """How often it has gone to sleep."""
        with open(f'{self._path}/status', 'rb') as status:
            return int(status.read().partition(SWITCHES)[2].split(maxsplit=1)[0])

    def sample_polling(self):
        """Set `always_polls`, once, while all other threads are idle.

        Not of ros::Rate, which may work later.
        """
        if self.always_polls is not None or self.sleeps_by_wall_time:
            return
        begin, (_, waited, runs), passed, runs_now = time.monotonic(), self.usage, 0.0, 0
        while runs_now < MIN_POLLS and passed <= SAMPLE_TIME:
            time.sleep(SAMPLE_TIME)
            _, waited_now, runs_in_all = self.usage
            runs_now = runs_in_all - runs
            passed = time.monotonic() - begin - (waited_now - waited) / 1e9
        self.always_polls = runs_now >= MIN_POLLS

    def sleeps_longer_than(self, limit, asleep_at):
        """Return whether its current sleep exceeds `limit` (s), not only because a timer is late.

        :param asleep_at: a time at which it slept (monotonic, s)
        """
        runs, now = self.usage[2], time.monotonic()
        if runs != self._runs:
            has_only_polled = runs - 1 == self._runs
            if self._sleep_time > limit:
                self._long_sleeps += 1
            elif (self._long_sleeps < SURE_SLEEPS
                  or has_only_polled and now - self._sleep_begin < limit):
                self._long_sleeps = 0
            # This sleep takes as long as the one before.
            self._sleep_is_long = (has_only_polled and self._sleep_time > 1.5 * limit
                                   and self._long_sleeps >= SURE_SLEEPS)
            self._runs, self._sleep_begin = runs, now
            self.sleeps_seen += 1
        self._sleep_time = asleep_at - self._sleep_begin
        if self._sleep_time > MAX_LATE * limit:
            self._long_sleeps = SURE_SLEEPS
        self._sleep_is_long |= self._sleep_time > limit and self._long_sleeps >= SURE_SLEEPS
        return self._sleep_is_long

    def _reader(self, opened, name):
        """Open a file; return a function that reads it.

        :param opened: contextlib.ExitStack that closes it
        """
        file = os.open(f'{self._path}/{name}', os.O_RDONLY)
        opened.callback(os.close, file)
        return partial(os.pread, file, MAX_LINE, 0)
