"""What the processes need, which must not grow."""

from typing import NamedTuple

import psutil

MEGABYTE = 2**20
FEWEST = 16  # measurements, to tell a trend


class Usage(NamedTuple):
    """What a process needs."""

    memory: float  # MB, resident
    threads: int
    files: int  # open

    @classmethod
    def of(cls, pid):
        process = psutil.Process(pid)
        return cls(process.memory_info().rss / MEGABYTE, process.num_threads(), process.num_fds())

    def __str__(self):
        return f'{self.memory:.4g} MB, {self.threads} threads, {self.files} files'


GROWTH = Usage(memory=3.0, threads=2, files=3)  # from one quarter of a run to the next


def growing(measured):
    """Return which fields of a list of at least FEWEST Usages grow on and on, as a list of names.

    What a leak takes is never given back: the least that is needed in a quarter of the run grows
    from each quarter to the next. What the allocator keeps grows once or twice, and threads and
    files that a busy machine is slow to end are not always there.
    """
    ends = [len(measured) * quarter // 4 for quarter in range(5)]
    least = [Usage(*map(min, zip(*measured[start:end]))) for start, end in zip(ends, ends[1:])]
    return [name for name, allowed in GROWTH._asdict().items()
            if all(getattr(after, name) - getattr(before, name) >= allowed
                   for before, after in zip(least, least[1:]))]
