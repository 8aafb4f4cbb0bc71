"""Processes that a test starts, watches and ends: a ROS master, nodes, commands."""

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import threading
from collections import deque

import rosgraph
from odometry_launch.process_guard import GuardedProcess

from odometry_tests.waiting import PATIENCE, TIMEOUT, wait_until

# roslaunch and roscore say so ten seconds of wall time after they have started a master, however
# busy the machine is; whoever reads it types the command again.
GAVE_UP = 'could not contact master'
ATTEMPTS = 5

started = deque(maxlen=20)  # the latest Processes of this test; a soak starts hundreds


class Process:
    """A command with its output."""

    def __init__(self, *command, env=None, start=GuardedProcess, **popen_options):
        """Start it; `env` is added to the environment.

        :param start: GuardedProcess, or Forked for a Python script
        """
        self.command = ' '.join(map(str, command))
        # Where it is set, Python's programs hide that their output waits in a buffer.
        environment = {**os.environ, 'PYTHONUNBUFFERED': '', **(env or {})}
        # Nothing is left of it when pytest is killed.
        self._process = start(*command, env=environment, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, **popen_options)
        self._changed = threading.Condition()
        self._lines = {'stdout': [], 'stderr': []}
        self._open = set(self._lines)
        self._readers = [self._read('stdout'), self._read('stderr')]
        started.append(self)

    @property
    def pid(self):
        return self._process.pid

    @property
    def stdout(self):
        return '\n'.join(self._lines['stdout'])

    @property
    def stderr(self):
        return '\n'.join(self._lines['stderr'])

    @property
    def output(self):
        """Both together, stdout first."""
        return f'{self.stdout}\n{self.stderr}'

    @property
    def running(self):
        return self._process.poll() is None

    @property
    def state(self):
        return 'is running' if self.running else f'has ended with status {self._process.poll()}'

    def wait_for_output(self, text, timeout=TIMEOUT):
        """Return once the text has been printed to stdout or stderr."""
        bound = timeout * PATIENCE
        with self._changed:
            self._changed.wait_for(lambda: text in self.output or not self._open, bound)
            how = f'has run for {bound:g} s' if self._open else 'has ended'
        assert text in self.output, \
            f'{self.command} {how} without {text!r}; it printed:\n{self.output}'

    def send(self, signum):
        self._process.send_signal(signum)

    def wait(self, timeout=TIMEOUT):
        """Return the exit status once the command has ended and all its output is read.

        No traceback is ever a user's error message: one fails the test.
        """
        try:
            status = self._process.wait(timeout * PATIENCE)
        except subprocess.TimeoutExpired:
            raise AssertionError(f'{self.command} has not ended within {timeout * PATIENCE:g} s; '
                                 f'it printed:\n{self.output}') from None
        for reader in self._readers:
            reader.join(TIMEOUT * PATIENCE)
        assert 'Traceback' not in self.output, self.output
        return status

    def end(self, signum=signal.SIGINT, timeout=TIMEOUT):
        """Send a signal and return the exit status."""
        if self.running:
            self.send(signum)
        return self.wait(timeout)

    def __enter__(self):
        return self

    def __exit__(self, kind=None, *_):
        """End it, with everything it has started; whoever does not obey Ctrl-C fails the test."""
        try:
            if self.running:
                self.send(signal.SIGINT)
                self._process.wait(TIMEOUT * PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.terminate()
            self._process.wait()
            assert kind, f'{self.command} has not ended on Ctrl-C; it printed:\n{self.output}'

    def _read(self, name):
        stream, lines = getattr(self._process, name), self._lines[name]

        def collect():
            with stream:
                for line in stream:
                    with self._changed:
                        lines.append(line.decode(errors='replace').rstrip('\n'))
                        self._changed.notify_all()
            with self._changed:
                self._open.discard(name)
                self._changed.notify_all()

        reader = threading.Thread(target=collect, daemon=True)
        reader.start()
        return reader


class Master(Process):
    """A ROS master of its own, which this process and its children use from now on.

    So is the address of loopback at which all of them listen: a master that knows of a node that was
    killed tells whoever has that node's address of other publishers, and asks it to shut down. Were
    there only one address, that could be a node of another run.

    roscore would give up after 10 s in which its master has not answered, as on a busy machine.
    """

    def __init__(self, use_sim_time=False, port=None, **options):
        """Start it and return once it answers.

        :param port: of own_address(); None: a free one
        :param options: those of a Process
        """
        self._port = contextlib.ExitStack()
        address = own_address()
        port = port or self._port.enter_context(hold_port(address))
        os.environ.update(ROS_MASTER_URI=f'http://{address}:{port}', ROS_HOSTNAME=address)
        super().__init__(shutil.which('rosmaster'), '--core', '-p', port, **options)
        try:
            wait_until(rosgraph.is_master_online, 20.0, 'an answer from the ROS master')
        except BaseException:
            self.__exit__()
            raise
        rosgraph.Master('/test').setParam('/use_sim_time', use_sim_time)

    def __exit__(self, *exception):
        super().__exit__(*exception)
        self._port.close()


@contextlib.contextmanager
def launched(start, text):
    """Yield a Process of roslaunch or roscore that has printed a text.

    :param start: function that starts it, once more each time that it gives up
    """
    for _ in range(ATTEMPTS):
        with start() as process:
            try:
                process.wait_for_output(text)
            except AssertionError:
                if GAVE_UP in process.output:
                    continue
                raise
            yield process
            return
    raise AssertionError(f'{process.command} has given up {ATTEMPTS} times:\n{process.output}')


def own_address():
    """Return an address of loopback (127.64.0.0 to 127.127.255.255) that no other process returns."""
    return f'127.{64 + (os.getpid() >> 16)}.{os.getpid() >> 8 & 255}.{os.getpid() & 255}'


@contextlib.contextmanager
def hold_port(host='localhost'):
    """Yield a TCP port of this machine that is given to nobody else meanwhile.

    Only who is told of it can listen on it, or hold it as the demo does.
    """
    with socket.socket() as holder:
        holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        holder.bind((host, 0))
        yield holder.getsockname()[1]


def rosrun(package, program, *arguments, **options):
    """Start a node as rosrun does, but for its search, which takes longer than many a node."""
    return Process(path_of(package, program), *arguments, **options)


def path_of(package, program):
    """Return the path that rosrun starts."""
    folders = os.environ['CMAKE_PREFIX_PATH'].split(os.pathsep)
    places = [os.path.join(folder, 'lib', package, program) for folder in folders]
    return next(filter(os.path.exists, places))
