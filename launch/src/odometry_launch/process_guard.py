"""Child processes that end with the process that started them, even if it is killed.

usage: python3 -I -S process_guard.py COMMAND [ARGUMENT...]

As a program it runs a command in place of itself.
"""

import os
import signal
import socket
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

REAPER = Path(__file__).with_name('reaper.py')
STANDARD_FILES = range(3)
STANDARD_OUTPUT = 1
MAX_LINE = 64  # bytes
ENDING_SIGNALS = signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT


class GuardedProcess:
    """A command that ends, with everything it has started, when it or this process ends."""

    def __init__(self, *command, **popen_options):
        """Start it in a new session, with an empty standard input."""
        self._lifeline, theirs = socket.socketpair()
        self._lifeline.settimeout(None)  # rospy sets another default
        with theirs:
            self._popen = subprocess.Popen(
                [sys.executable, '-I', '-S', REAPER, *map(str, command)], stdin=theirs,
                start_new_session=True, **popen_options)
        self.stdout, self.stderr = self._popen.stdout, self._popen.stderr
        self._pid = None

    @property
    def pid(self):
        """The process id of the command itself; raise ProcessLookupError if it never started."""
        if self._pid is None:
            line = self._lifeline.recv(MAX_LINE)
            if not line:
                raise ProcessLookupError('the command never started')
            self._pid = int(line)
        return self._pid

    def poll(self):
        """Return the exit status as subprocess does, None while anything is running."""
        status = self._popen.poll()
        if status is not None and self._lifeline.fileno() >= 0:
            with suppress(ProcessLookupError):
                self._pid = self.pid  # while it can be read
            self._lifeline.close()
        return status

    def wait(self, timeout=None):
        """Return the exit status once everything has ended; raise subprocess.TimeoutExpired."""
        self._popen.wait(timeout)
        return self.poll()

    def send_signal(self, signum):
        """Send a signal to the command itself."""
        if self.poll() is None:
            with suppress(ProcessLookupError):
                os.kill(self.pid, signum)

    def terminate(self):
        """Start to end everything, and return at once."""
        with suppress(OSError):
            self._lifeline.shutdown(socket.SHUT_WR)


def run_in_place(*command):
    """Run a command in place of this process, and return its exit status.

    The first signal ends the command and everything it has started; later signals do not cut that
    short. If the command then exits with 0, so does this process.
    """
    _open_standard_files()
    received, processes = [], []

    def end(signum, _frame):
        received.append(signum)
        for process in processes:
            process.terminate()

    for signum in ENDING_SIGNALS:
        # nohup ignores SIGHUP.
        if signum != signal.SIGHUP or signal.getsignal(signum) != signal.SIG_IGN:
            signal.signal(signum, end)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING_SIGNALS)  # ./ws blocks them until here
    process = GuardedProcess(*command)
    processes.append(process)
    if received:
        process.terminate()
    status = process.wait()
    if not received:
        return status if status >= 0 else 128 - status
    if os.isatty(STANDARD_OUTPUT):
        with suppress(OSError):
            os.write(STANDARD_OUTPUT, b'\n')  # so that the shell's prompt starts a new line
    return status and 128 + received[0]


def _open_standard_files():
    """Open closed standard files, or a socket would get their descriptors."""
    for descriptor in STANDARD_FILES:
        try:
            os.fstat(descriptor)
        except OSError:
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)


if __name__ == '__main__':
    sys.exit(run_in_place(*sys.argv[1:]))
