"""Processes that a check starts: nodes as they are, and everything that they start."""

import contextlib
import os
import signal
import subprocess
import tempfile
import time
import uuid

import psutil

MARK = 'ODOMETRY_CHECK'  # in the environment of a process and its descendants, wherever they hide
ENDING = (signal.SIGTERM, 1.0), (signal.SIGKILL, 5.0)  # and how long it then may take (s of wall time)
LAST = 2**20  # bytes
LOOK_PERIOD = 0.05  # s


class Started:
    """A process in a session of its own, without a keyboard; it ends with all that it has started."""

    def __init__(self, command):
        """Start a command (a list)."""
        self._mark = str(uuid.uuid4())
        self._output = tempfile.TemporaryFile()  # noqa: SIM115
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=self._output, stderr=subprocess.STDOUT,
            start_new_session=True, env={**os.environ, MARK: self._mark, 'PYTHONUNBUFFERED': '1'})

    @property
    def status(self):
        """Its exit status; None while it runs."""
        return self._process.poll()

    @property
    def output(self):
        """What it has printed last."""
        size = os.fstat(self._output.fileno()).st_size
        return os.pread(self._output.fileno(), LAST, max(0, size - LAST)).decode(errors='replace')

    def family(self):
        """Return this process and all descendants that still run."""
        return [process for process in psutil.process_iter(['environ', 'status'])
                if (process.info['environ'] or {}).get(MARK) == self._mark
                and process.info['status'] != psutil.STATUS_ZOMBIE]

    def cpu_time(self):
        """Return the processor time (s) of this process; None if it has ended."""
        with contextlib.suppress(psutil.NoSuchProcess):
            return sum(psutil.Process(self._process.pid).cpu_times()[:2])

    def interrupt(self):
        """Press Ctrl-C."""
        if self.status is None:
            os.killpg(self._process.pid, signal.SIGINT)

    def wait(self, timeout):
        """Return whether all of them have ended within `timeout` s of wall time."""
        end = time.monotonic() + timeout
        while self.status is None or self.family():
            if time.monotonic() > end:
                return False
            time.sleep(LOOK_PERIOD)
        return True

    def end(self):
        """End all of them, by force if need be."""
        for signum, patience in ENDING:
            for process in self.family():
                with contextlib.suppress(psutil.NoSuchProcess):
                    process.send_signal(signum)
            if self.wait(patience):
                return
