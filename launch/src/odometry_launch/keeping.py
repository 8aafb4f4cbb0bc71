"""Processes that never outlive the one that started them, however that ends.

usage: python3 -I -S keeping.py COMMAND [ARGUMENT...]

As a program it stands in for a command.
"""

import contextlib
import os
import signal
import socket
import subprocess
import sys
from pathlib import Path

KEEPER = Path(__file__).with_name('keeper.py')
STANDARD_FILES = range(3)
STANDARD_OUTPUT = 1
MAX_LINE = 64  # bytes
ENDING_SIGNALS = signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT


class Kept:
    """A command that has ended, with all that it has started, soon after this process has."""

    def __init__(self, *command, **popen_options):
        """Start it; its standard input is empty, and its session its own."""
        self._lifeline, theirs = socket.socketpair()
        with theirs:
            self._popen = subprocess.Popen(
                [sys.executable, '-I', '-S', KEEPER, *map(str, command)], stdin=theirs,
                start_new_session=True, **popen_options)
        self.stdout, self.stderr = self._popen.stdout, self._popen.stderr
        self._pid = None

    @property
    def pid(self):
        """The process id of the command itself; raise ProcessLookupError if it never was one."""
        if self._pid is None:
            line = self._lifeline.recv(MAX_LINE)
            if not line:
                raise ProcessLookupError('the keeper has ended before the command began')
            self._pid = int(line)
        return self._pid

    def poll(self):
        """Return the exit status as subprocess does, None while anything is running."""
        status = self._popen.poll()
        if status is not None and self._lifeline.fileno() >= 0:
            with contextlib.suppress(ProcessLookupError):
                self._pid = self.pid  # while it can be read
            self._lifeline.close()
        return status

    def wait(self, timeout=None):
        """Return the exit status once all has ended; raise subprocess.TimeoutExpired."""
        self._popen.wait(timeout)
        return self.poll()

    def send_signal(self, signum):
        """Send a signal to the command itself."""
        if self.poll() is None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signum)

    def let_go(self):
        """Ask for everything to be ended; return at once."""
        with contextlib.suppress(OSError):
            self._lifeline.shutdown(socket.SHUT_WR)


def stand_in(*command):
    """Run a command in this process's stead and return its exit status.

    Whatever ends this process, from its first moment, ends the command and all that it has
    started. Of several signals the first is obeyed, and the others do not cut that short. A
    command that exits with 0 all the same meant to.
    """
    _open_standard_files()
    received, kept = [], []

    def end(signum, _frame):
        received.append(signum)
        for one in kept:
            one.let_go()

    for signum in ENDING_SIGNALS:
        # nohup has SIGHUP ignored.
        if signum != signal.SIGHUP or signal.getsignal(signum) != signal.SIG_IGN:
            signal.signal(signum, end)
    # ./ws has them wait until here.
    signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING_SIGNALS)
    kept.append(Kept(*command))
    if received:
        kept[0].let_go()
    status = kept[0].wait()
    if received:
        _end_line()
        return status and 128 + received[0]
    return status if status >= 0 else 128 - status


def _open_standard_files():
    """Open those that are closed, or a socket would be taken for one of them."""
    for descriptor in STANDARD_FILES:
        try:
            os.fstat(descriptor)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)


def _end_line():
    """Leave a line for the shell's prompt."""
    with contextlib.suppress(OSError):
        if os.isatty(STANDARD_OUTPUT):
            os.write(STANDARD_OUTPUT, b'\n')


if __name__ == '__main__':
    sys.exit(stand_in(*sys.argv[1:]))
