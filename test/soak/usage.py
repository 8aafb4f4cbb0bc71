"""What the processes need, which must not grow."""

from pathlib import Path
from typing import NamedTuple

from checks import Violation

MEMORY_GROWTH = 8.0  # MB
THREAD_GROWTH = 4
FILE_GROWTH = 8


class Usage(NamedTuple):
    """What a process needs."""

    memory: float  # MB, resident
    threads: int
    files: int  # open

    @classmethod
    def of(cls, pid):
        """Ask Linux."""
        process = Path('/proc', str(pid))
        fields = dict(line.split(':', 1) for line in
                      (process / 'status').read_text().splitlines())
        return cls(int(fields['VmRSS'].split()[0]) / 1024, int(fields['Threads']),
                   sum(1 for _ in (process / 'fd').iterdir()))


class UsageCheck:
    """Whether processes stay as small as they were."""

    def __init__(self):
        """Begin with nothing measured."""
        self.first, self.last = {}, {}

    def check(self, pids):
        """Measure processes, a dictionary of their ids by name, against the first time."""
        self.last = {name: Usage.of(pid) for name, pid in pids.items()}
        self.first = self.first or self.last
        for name, now in self.last.items():
            first = self.first[name]
            if (now.memory > first.memory + MEMORY_GROWTH
                    or now.threads > first.threads + THREAD_GROWTH
                    or now.files > first.files + FILE_GROWTH):
                raise Violation(f'{name} has grown from {first} to {now}')
