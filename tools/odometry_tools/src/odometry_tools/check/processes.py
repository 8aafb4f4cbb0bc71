"""Child processes of a check, with all of their descendants."""

import contextlib
import os
import re
import signal
import subprocess
import tempfile
import threading
import time
import uuid
from pathlib import Path

import psutil

MARK = 'ODOMETRY_CHECK_'  # in the environment of a process and all of its descendants
# Signals to end a process, and how long to wait after each (s of wall time).
ENDING = (signal.SIGTERM, 1.0), (signal.SIGKILL, 5.0)
LAST = 2**20  # bytes of output kept
CHUNK = 2**16
READ_PATIENCE = 1.0  # s of wall time to read the rest after a process has ended
POLL_PERIOD = 0.05  # s of wall time


class ChildProcess:
    """A process in a session of its own, which ends with all of its descendants.

    Its standard input is a file with an empty line, whose offset shows whether it was read.
    """

    def __init__(self, command, environment=()):
        """Start a command (a list), with additional variables."""
        self._mark = f'{MARK}{uuid.uuid4().hex}'
        self._keyboard = tempfile.TemporaryFile()  # noqa: SIM115
        os.pwrite(self._keyboard.fileno(), b'\n', 0)
        self._process = subprocess.Popen(
            command, stdin=self._keyboard, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            start_new_session=True,
            env={**os.environ, 'PYTHONUNBUFFERED': '1', **dict(environment), self._mark: ''})
        self._output = b''
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        while chunk := self._process.stdout.read1(CHUNK):
            self._output = (self._output + chunk)[-LAST:]

    @property
    def status(self):
        """Its exit status; None while it runs."""
        return self._process.poll()

    @property
    def output(self):
        """The last MiB that it has printed."""
        if self.status is not None:
            self._reader.join(READ_PATIENCE)
        return self._output.decode(errors='replace')

    @property
    def has_read_keyboard(self):
        """Whether it has read from its standard input."""
        return os.lseek(self._keyboard.fileno(), 0, os.SEEK_CUR) > 0

    def family(self):
        """Return the process and its descendants, those that run."""
        return [process for process in psutil.process_iter(['environ', 'status'])
                if self._mark in (process.info['environ'] or ())
                and process.info['status'] != psutil.STATUS_ZOMBIE]

    def cpu_time(self):
        """Return the processor time (s) of this process and its children; None if it has ended."""
        with contextlib.suppress(psutil.NoSuchProcess):
            process = psutil.Process(self._process.pid)
            return sum(sum(one.cpu_times()[:2])
                       for one in (process, *process.children(recursive=True)))

    def is_cpp(self, pids):
        """Return whether one of these of the family, or without ids any of it, uses roscpp."""
        with contextlib.suppress(psutil.Error):
            return any('libroscpp' in region.path
                       for process in self.family() if not pids or process.pid in pids
                       for region in process.memory_maps())

    def interrupt(self):
        """Press Ctrl-C."""
        if self.status is None:
            os.killpg(self._process.pid, signal.SIGINT)

    def wait(self, timeout):
        """Wait up to `timeout` s of wall time; return whether all of them have ended."""
        end = time.monotonic() + timeout
        while self.status is None or self.family():
            if time.monotonic() > end:
                return False
            time.sleep(POLL_PERIOD)
        return True

    def end(self):
        """End the process and its descendants, by SIGKILL if need be."""
        for signum, patience in ENDING:
            for process in self.family():
                with contextlib.suppress(psutil.NoSuchProcess):
                    process.send_signal(signum)
            if self.wait(patience):
                return


def has_node_logged(folder):
    """Return whether rospy.init_node has begun a log in a folder; roslaunch's do not count."""
    return any(not re.search(r'^roslaunch-|-stdout\.log$', path.name)
               for path in Path(folder).rglob('*.log'))
