"""What /proc shows of a thread."""

import os
import time

# Functions of the kernel in which time.sleep() sleeps; Python to 3.10 selects, as servers do, too
SLEEP, SELECT = b'hrtimer_nanosleep', b'do_select'
SLEEPING, STOPPED, ENDED = b'S', b'tT', b'ZX'  # states in /proc/PID/task/TID/stat
NOT_TOLD = b'0'  # in place of a function of the kernel: the thread runs, or this kernel tells nothing
LONGEST_LINE = 128  # bytes, of wchan and of schedstat
SLEEPS = b'\nvoluntary_ctxt_switches:'  # in /proc/PID/task/TID/status
SURVEY_TIME = 0.05  # s of wall time in which a thread did not wait for a processor
POLL_RUNS = 20  # in that time, without work; ros::Rate and ros::Timer poll every millisecond

_waits = set()  # functions of the kernel in which threads have been seen asleep


class Thread:
    """A thread of any process; whatever asks for its state raises OSError if it has ended."""

    def __init__(self, pid, tid):
        """Open the files that each look reads."""
        self.pid, self.tid = pid, tid
        self._path, self._wait = f'/proc/{pid}/task/{tid}', None
        self._schedstat, self._wchan = self._open('schedstat'), self._open('wchan')
        self.ignored = False  # whether it need not rest
        self.polls = None  # whether it looks for work all the time, as timers of roscpp do
        self.is_asleep = False  # when it was looked at last
        self.settled = None  # its usage when it had fallen asleep
        self.naps_seen = 0
        self._nap, self._nap_begin, self._nap_time, self._nap_is_long = 0, 0.0, 0.0, False

    def close(self):
        """Close its files."""
        os.close(self._schedstat)
        os.close(self._wchan)

    @property
    def name(self):
        """The name that its process gave it."""
        return self._read('comm').decode(errors='replace').strip()

    def look(self):
        """Return whether it sleeps."""
        self._wait = os.pread(self._wchan, LONGEST_LINE, 0)
        self.is_asleep = self._wait in _waits or self._is_asleep_in(self._wait)
        return self.is_asleep

    def _is_asleep_in(self, wait):
        state = self.state
        if state == SLEEPING and wait != NOT_TOLD:
            _waits.add(wait)
        # One that has begun to sleep since the first question will be asked once more.
        return state in ENDED or state == SLEEPING and (wait != NOT_TOLD or not _waits)

    @property
    def state(self):
        """Its state, as in /proc/PID/task/TID/stat."""
        return self._read('stat').rpartition(b')')[2][1:2]

    def settle(self):
        """Return whether it sleeps, or has not run since it was last seen asleep."""
        usage = os.pread(self._schedstat, LONGEST_LINE, 0)
        if usage != self.settled:
            if not self.look():
                return False
            self.settled = usage
        return True

    def is_settled(self):
        """Return whether it has not run since settle(); its CPU time alone may not tell.

        A virtual machine that was kept from its processor counts the next time on it as lost.
        """
        return os.pread(self._schedstat, LONGEST_LINE, 0) == self.settled

    @property
    def is_free(self):
        """Whether nobody waits until it rests."""
        return self.polls or self.ignored

    @property
    def naps(self):
        """Whether it slept by wall time, or selected, when it was looked at last."""
        return self._wait in (SLEEP, SELECT)

    @property
    def sleeps_by_wall_time(self):
        """Whether it certainly did."""
        return self._wait == SLEEP

    @property
    def usage(self):
        """Its CPU time (ns), how long it waited for a processor (ns), and how often it has run."""
        return tuple(map(int, os.pread(self._schedstat, LONGEST_LINE, 0).split()))

    @property
    def runs(self):
        """How often it has run."""
        return self.usage[2]

    @property
    def sleeps(self):
        """How often it has begun to sleep."""
        return int(self._read('status').partition(SLEEPS)[2].split(maxsplit=1)[0])

    def survey(self):
        """Find out, once and while all others rest, whether it polls."""
        if self.polls is not None:
            return
        begin, (_, waited, runs), passed, runs_now = time.monotonic(), self.usage, 0.0, 0
        while runs_now < POLL_RUNS and passed <= SURVEY_TIME:
            time.sleep(SURVEY_TIME)
            _, waited_now, runs_in_all = self.usage
            runs_now = runs_in_all - runs
            passed = time.monotonic() - begin - (waited_now - waited) / 1e9
        self.polls = runs_now >= POLL_RUNS

    def naps_longer_than(self, limit, runs, asleep_at):
        """Return whether its nap takes longer than `limit` (s).

        :param runs: how often it has run
        :param asleep_at: a time at which it slept (monotonic, s)
        """
        if runs != self._nap:
            # If it did no more than look, this nap takes as long as the one before.
            self._nap_is_long = runs - 1 == self._nap and self._nap_time > 1.5 * limit
            self._nap, self._nap_begin = runs, time.monotonic()
            self.naps_seen += 1
        self._nap_time = asleep_at - self._nap_begin
        self._nap_is_long |= self._nap_time > limit
        return self._nap_is_long

    def _open(self, name):
        return os.open(f'{self._path}/{name}', os.O_RDONLY)

    def _read(self, name):
        with open(self._open(name), 'rb') as file:
            return file.read()
