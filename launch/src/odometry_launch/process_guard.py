"""Child processes that end with the process that started them, even if it is killed."""

import os
import socket
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

REAPER = Path(__file__).with_name('reaper.py')
MAX_LINE = 64  # bytes


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
