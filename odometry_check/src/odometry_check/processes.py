"""Processes that a check starts: nodes as they are, and everything that they start."""

import os
import signal
import subprocess
import tempfile
import threading
import time
import uuid

import psutil

MARK = 'ODOMETRY_CHECK'  # in the environment of a process and its descendants, wherever they hide
INTERRUPT_PATIENCE = 20.0  # s of wall time, which even a busy machine does not need
# How a process is asked to end, and how long it then may take (s of wall time).
ASKING = (signal.SIGINT, INTERRUPT_PATIENCE), (signal.SIGTERM, 1.0), (signal.SIGKILL, 5.0)
LAST = 2**20  # bytes
LOOK_PERIOD = 0.1  # s


class Started:
    """A process in a session of its own, without a keyboard; it ends with all that it has started."""

    def __init__(self, command, on_end=lambda status: None):
        """Start a command (a list); call a function of its exit status on another thread."""
        self._mark = str(uuid.uuid4())
        self._output = tempfile.TemporaryFile()  # noqa: SIM115
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=self._output, stderr=subprocess.STDOUT,
            start_new_session=True, env={**os.environ, MARK: self._mark, 'PYTHONUNBUFFERED': '1'})
        self.status, self._ended = None, threading.Event()  # its exit status, once it has ended
        threading.Thread(target=self._wait, args=[on_end], daemon=True).start()

    def _wait(self, on_end):
        self.status = self._process.wait()
        self._ended.set()
        on_end(self.status)

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
        try:
            return sum(psutil.Process(self._process.pid).cpu_times()[:2])
        except psutil.NoSuchProcess:
            return None

    def interrupt(self):
        """Press Ctrl-C."""
        if self.status is None:
            os.killpg(self._process.pid, signal.SIGINT)

    def wait(self, timeout):
        """Return whether all of them have ended within `timeout` s of wall time."""
        end = time.monotonic() + timeout
        self._ended.wait(timeout)
        while is_there := self.status is None or bool(self.family()):
            if time.monotonic() > end:
                break
            time.sleep(LOOK_PERIOD)
        return not is_there

    def end(self, is_stubborn=False):
        """End all of them, by force if need be; return whether Ctrl-C was enough.

        :param is_stubborn: whether Ctrl-C is known not to end them
        """
        for signum, patience in ASKING[is_stubborn:]:
            self.interrupt() if signum == signal.SIGINT else self._send(signum)
            if self.wait(patience):
                return signum == signal.SIGINT
        return False

    def _send(self, signum):
        for process in self.family():
            try:
                process.send_signal(signum)
            except psutil.NoSuchProcess:
                continue
