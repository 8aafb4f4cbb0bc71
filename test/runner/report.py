"""What a run says: a line for each test file, the output of what failed, the sum."""

import shlex
import shutil
import sys
import textwrap

from results import Counts

FILE_WIDTH = 34


class Report:
    """Prints the run as it goes, and counts."""

    def __init__(self, total):
        """Expect so many jobs."""
        self._left = total
        self._live = sys.stdout.isatty()
        self.counts = Counts()
        self.again = []

    def show_progress(self, running):
        """Show what runs, in one line that is rewritten on a terminal."""
        if self._live:
            names = ', '.join(f'{one.job.name} {one.seconds:.0f} s' for one in running)
            text = f'{self._left} to go: {names}'[:shutil.get_terminal_size().columns - 1]
            print(f'\r\033[K{text}', end='', flush=True)

    def add(self, cases, seconds):
        """Print the lines of a job that has ended after so many seconds."""
        self._left -= 1
        files = list(dict.fromkeys(case.file for case in cases))
        for file in files:
            own = [case for case in cases if case.file == file]
            took = seconds if len(files) == 1 else sum(case.seconds for case in own)
            self._add_file(file, own, took)

    def _add_file(self, file, cases, took):
        counts = sum((case.counts for case in cases), Counts())
        self.counts += counts
        words = [f'{number} {word}' for number, word in zip(counts, Counts._fields) if number]
        start = '\r\033[K' if self._live else ''
        print(f'{start}{file:{FILE_WIDTH}} {", ".join(words):24} {took:6.1f} s')
        for case in cases:
            if case.skipped is not None:
                print(f'    skipped {case.name}: {case.skipped}')
            if case.failure is not None:
                self._add_failure(case)
        sys.stdout.flush()

    def _add_failure(self, case):
        print(f'    FAILED {case.name}\n{textwrap.indent(case.failure, "        ")}')
        single = case.file.startswith('test_') and case.name != case.file
        self.again.append(shlex.quote(f'{case.file}::{case.name}' if single else case.file))

    def close(self, logs):
        """Say how to repeat what failed, and where everything is that was printed."""
        if self._live:
            print('\r\033[K', end='')
        if self.again:
            print(f'again: ./ws test {" ".join(dict.fromkeys(self.again))}')
        print(f'everything that was printed: {logs}', flush=True)
