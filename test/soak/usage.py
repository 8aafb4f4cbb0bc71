"""What the processes need, which must not grow."""

from typing import NamedTuple

import psutil
from checks import Violation

MEGABYTE = 2**20
FEWEST = 16  # measurements, to tell a trend
MANY = 64  # measurements; so many at a time are looked at from then on


class Usage(NamedTuple):
    """What a process needs."""

    memory: float  # MB, resident
    threads: int
    files: int  # open

    @classmethod
    def of(cls, pid):
        """Ask the system."""
        process = psutil.Process(pid)
        return cls(process.memory_info().rss / MEGABYTE, process.num_threads(), process.num_fds())


GROWTH = Usage(memory=3.0, threads=2, files=3)  # from one quarter of a run to the next


class UsageCheck:
    """Whether processes grow on and on.

    What a leak takes is never given back: the least that is needed in a quarter of the run grows
    from each quarter to the next. What the allocator keeps grows once or twice, and threads and
    files that a busy machine is slow to end are not always there.
    """

    def __init__(self):
        """Begin with nothing measured."""
        self.first, self.last = {}, {}
        self._seen = {}

    def check(self, pids):
        """Measure processes, a dictionary of their ids by name."""
        self.last = {name: Usage.of(pid) for name, pid in pids.items()}
        self.first = self.first or self.last
        for name, now in self.last.items():
            seen = self._seen.setdefault(name, [])
            seen.append(now)
            if FEWEST <= len(seen) and (len(seen) < MANY or len(seen) % MANY == 0):
                _check_trend(name, seen)


def _check_trend(name, seen):
    """Raise Violation if something has grown from each quarter to the next."""
    ends = [len(seen) * quarter // 4 for quarter in range(5)]
    quarters = [seen[start:end] for start, end in zip(ends, ends[1:])]
    for what, allowed in GROWTH._asdict().items():
        least = [min(getattr(usage, what) for usage in quarter) for quarter in quarters]
        if all(after - before >= allowed for before, after in zip(least, least[1:])):
            raise Violation(f'the {what} of {name} grow: at least {least} in the quarters of the run')
