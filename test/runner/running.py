"""Jobs as processes: some at a time, and none left behind."""

import contextlib
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter

from odometry_launch.process_guard import GuardedProcess
from odometry_tests.processes import ATTEMPTS, GAVE_UP

JOBS_PER_PROCESSOR = 3  # most tests wait most of the time, for each other's processes
END_TIMEOUT = 20.0  # s; a test that is interrupted ends its nodes first
POLL_PERIOD = 0.05  # s
# Ends with its parent, whatever becomes of that.
BUSY_LOOP = 'import os\nparent = os.getppid()\nwhile os.getppid() == parent:\n    pass\n'


class Running:
    """A job that runs, and its output."""

    def __init__(self, job, log):
        """Start it.

        :param log: path of the file for its output
        """
        self.job = job
        self._log = log
        self._start = time.monotonic()
        shutil.rmtree(job.results, ignore_errors=True)
        job.results.mkdir(parents=True)
        with open(log, 'wb') as file:
            # In a session of its own: Ctrl-C is passed on by interrupt(), and then once.
            self._process = GuardedProcess(*job.command, cwd=job.results, stdout=file,
                              stderr=subprocess.STDOUT)

    @property
    def status(self):
        """Its exit status, None while it runs."""
        return self._process.poll()

    @property
    def seconds(self):
        """How long it has been running (s)."""
        return time.monotonic() - self._start

    @property
    def output(self):
        """What it has printed."""
        return self._log.read_text(errors='replace')

    @property
    def has_given_up(self):
        """Whether its tests were never run, since it had no patience with its master."""
        return self.job.starts_master and GAVE_UP in self.output

    def interrupt(self):
        """Press Ctrl-C."""
        self._process.send_signal(signal.SIGINT)

    def end(self):
        """Wait until it has ended, and kill what does not."""
        try:
            self._process.wait(END_TIMEOUT)
        except subprocess.TimeoutExpired:
            self._process.terminate()
            self._process.wait()


def run(jobs, processors, logs, on_tick):
    """Run jobs, and yield each as a Running when it has ended; what has given up is run again.

    :param jobs: those that draw run after all others, one for each processor
    :param processors: how many there are
    :param logs: folder for their output
    :param on_tick: called with the list of Running again and again meanwhile
    """
    waiting = sorted(jobs, key=lambda job: job.draws)
    running, runs = [], Counter()
    try:
        while waiting or running:
            while waiting and _may_start(waiting[0], running, processors):
                job = waiting.pop(0)
                runs[job.name] += 1
                running.append(Running(job, logs / f'{job.results.name}.txt'))
            on_tick(running)
            time.sleep(POLL_PERIOD)
            for ended in [one for one in running if one.status is not None]:
                running.remove(ended)
                if ended.has_given_up and runs[ended.job.name] < ATTEMPTS:
                    waiting.insert(0, ended.job)
                else:
                    yield ended
    finally:
        for one in running:
            one.interrupt()
        for one in running:
            one.end()


def _may_start(job, running, processors):
    at_a_time = processors if job.draws else JOBS_PER_PROCESSOR * processors
    return len(running) < at_a_time and all(one.job.draws == job.draws for one in running)


@contextlib.contextmanager
def load(processes):
    """Keep so many processes busy meanwhile."""
    busy = [subprocess.Popen([sys.executable, '-c', BUSY_LOOP]) for _ in range(processes)]
    try:
        yield
    finally:
        for process in busy:
            process.kill()
            process.wait()
