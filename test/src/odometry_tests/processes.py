"""Processes that a test starts, watches and ends: a ROS master, nodes, commands."""

import contextlib
import functools
import os
import signal
import socket
import subprocess
import sys
import tempfile
from collections import deque

import psutil
import rosgraph

from odometry_tests.process_guard import start_guarded
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

started = deque(maxlen=20)  # the latest Processes of this test


class Process:
    """A command with its output."""

    def __init__(self, *command, env=None, **popen_options):
        """Start it; `env` is added to the environment."""
        self.command = ' '.join(map(str, command))
        # Where it is set, Python's programs hide that their output waits in a buffer.
        environment = {**os.environ, 'PYTHONUNBUFFERED': '', **(env or {})}
        # Files, not pipes, which a reader would have to drain.
        self._outputs = [tempfile.TemporaryFile() for _ in ('stdout', 'stderr')]  # noqa: SIM115
        self._process = start_guarded(*command, env=environment, stdout=self._outputs[0],
                                      stderr=self._outputs[1], **popen_options)
        started.append(self)

    @functools.cached_property
    def pid(self):
        """Of the command itself, which the reaper has started."""
        return command_of(self._process).pid

    @property
    def stdout(self):
        return self._read(self._outputs[0])

    @property
    def stderr(self):
        return self._read(self._outputs[1])

    @property
    def output(self):
        return f'{self.stdout}\n{self.stderr}'

    @property
    def running(self):
        return self._process.poll() is None

    @property
    def state(self):
        return 'is running' if self.running else f'has ended with status {self._process.poll()}'

    def wait_for_output(self, text, timeout=TIMEOUT):
        wait_until(lambda: text in self.output or not self.running, timeout, lambda: (
            f'{text!r} from {self.command}; it printed:\n{self.output}'))
        assert text in self.output, \
            f'{self.command} {self.state} without {text!r}; it printed:\n{self.output}'

    def send(self, signum):
        with contextlib.suppress(ProcessLookupError):
            if self.running:
                os.kill(self.pid, signum)

    def wait(self, timeout=TIMEOUT):
        """Return the exit status once the command has ended.

        No traceback is ever a user's error message: one fails the test.
        """
        try:
            status = self._process.wait(timeout * PATIENCE)
        except subprocess.TimeoutExpired:
            raise AssertionError(f'{self.command} has not ended within {timeout * PATIENCE:g} s; '
                                 f'it printed:\n{self.output}') from None
        assert 'Traceback' not in self.output, self.output
        return status

    def end(self, signum=signal.SIGINT, timeout=TIMEOUT):
        self.send(signum)
        return self.wait(timeout)

    def __enter__(self):
        return self

    def __exit__(self, kind=None, *_):
        """End it, with everything it has started; a process that ignores Ctrl-C fails the test."""
        try:
            if self.running:
                self.send(signal.SIGINT)
                self._process.wait(TIMEOUT * PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.terminate()
            self._process.wait()
            assert kind, f'{self.command} has not ended on Ctrl-C; it printed:\n{self.output}'

    def _read(self, file):
        text = os.pread(file.fileno(), os.fstat(file.fileno()).st_size, 0).decode(errors='replace')
        return text.rpartition('\n')[0] if text.endswith('\n') or self.running else text


def command_of(reaper):
    """Return the psutil.Process of a command, once start_guarded() has started it.

    :param reaper: what start_guarded() has returned
    :raises ProcessLookupError: if the command has ended
    """
    def look():
        if reaper.poll() is not None:
            raise ProcessLookupError('the command has ended')
        return next(iter(psutil.Process(reaper.pid).children()), None)

    return wait_until(look, TIMEOUT, 'a command')


class Master(Process):
    """A ROS master, which this process and its children use from now on.

    All of them listen at this run's own loopback address: a master still calls the address of a node
    that was killed, and asks it to shut down. With one address for all runs, a node of another run
    might have it by then.

    roscore would give up after 10 s in which its master has not answered, as on a busy machine.
    """

    def __init__(self, use_sim_time=False, port=None):
        """Start it and return once it answers.

        :param port: of own_address(); None: a free one
        """
        self._port = contextlib.ExitStack()
        address = own_address()
        port = port or self._port.enter_context(hold_port(address))
        os.environ.update(ROS_MASTER_URI=f'http://{address}:{port}', ROS_HOSTNAME=address)
        super().__init__('rosmaster', '--core', '-p', port)
        try:
            wait_until(rosgraph.is_master_online, 20.0, 'an answer from the ROS master')
        except BaseException:
            self.__exit__()
            raise
        rosgraph.Master('/test').setParam('/use_sim_time', use_sim_time)

    def __exit__(self, *exception):
        super().__exit__(*exception)
        self._port.close()


def own_address():
    """Return an address of loopback (127.64.0.0 to 127.127.255.255) that no other process returns."""
    return f'127.{64 + (os.getpid() >> 16)}.{os.getpid() >> 8 & 255}.{os.getpid() & 255}'


@contextlib.contextmanager
def hold_port(host='localhost'):
    """Yield a TCP port of this machine that no other caller gets meanwhile.

    Only servers that set SO_REUSEADDR can listen on it.
    """
    with socket.socket() as holder:
        holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        holder.bind((host, 0))
        yield holder.getsockname()[1]


def rosrun(package, program, *arguments, **options):
    return Process(path_of(package, program), *arguments, **options)


def run(*command, status=0, timeout=TIMEOUT, **options):
    """Run a command; return its Process once it has ended with this exit status, or with any if that is None."""
    with Process(*command, **options) as process:
        assert process.wait(timeout) == status or status is None, \
            f'{process.command} {process.state}; it printed:\n{process.output}'
    return process


def run_script(script, *arguments, **options):
    return run(sys.executable, ROOT / script, *arguments, status=None, **options)


def assert_refused(ended, *words):
    """Assert that a node has ended with status 2 and one line with all the words in it."""
    assert ended.wait() == 2, ended.output
    line, = ended.stderr.splitlines()
    assert all(word in line for word in words), line


def path_of(package, program):
    folders = os.environ['CMAKE_PREFIX_PATH'].split(os.pathsep)
    places = [os.path.join(folder, 'lib', package, program) for folder in folders]
    return next(filter(os.path.exists, places))
