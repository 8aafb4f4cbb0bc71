"""However and whenever the demo is ended, nothing that it has started is left."""

import contextlib
import os
import signal
import socket
import subprocess
import time

import pytest
from odometry_tests.linux import marked, new_mark, wait_until_none
from odometry_tests.listening import assert_loopback_only
from odometry_tests.processes import hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.terminal import Terminal
from odometry_tests.waiting import wait_until

FAR = ('--distance', '100')
ENDING_TIME = 15.0  # s
START = 4.0  # s; most of its time the demo spends in its start
MOMENTS = 40
INT, TERM, KILL = [signal.SIGINT], [signal.SIGTERM], [signal.SIGKILL]
HANG_UP, QUIT, FIVE = [signal.SIGHUP], [signal.SIGQUIT], [signal.SIGINT] * 5
ENDINGS = [INT, TERM, KILL, HANG_UP, QUIT, FIVE]


def spread():
    """Return pairs of a moment (s from the start, or from the first progress) and signals."""
    if os.environ.get('HYPOTHESIS_PROFILE') != 'nightly':
        return ([(0.15, INT), (0.5, TERM), (0.8, FIVE), (1.1, INT), (1.6, KILL), (2.2, QUIT)],
                [(0.1, KILL), (0.3, HANG_UP)])
    half = MOMENTS // 2
    moments = [START * step / half for step in range(half)]
    return ([(moment, ending) for moment in moments for ending in (INT, TERM, KILL)]
            + [(moment, ENDINGS[3 + step % 3]) for step, moment in enumerate(moments)],
            [(moment, ENDINGS[step % len(ENDINGS)]) for step, moment in enumerate(moments)])


EARLY, DRIVING = spread()


class Demo:
    """A demo that nobody else looks after."""

    def __init__(self, *arguments):
        """Start it; it takes the port of a ROS_MASTER_URI of its own."""
        self._stack = contextlib.ExitStack()
        self.port = self._stack.enter_context(hold_port())
        self._output = os.memfd_create('output')
        self._stack.callback(os.close, self._output)
        self._mark = new_mark()
        self._process = subprocess.Popen(
            [ROOT / 'ws', 'demo', *arguments], stdout=self._output, stderr=subprocess.STDOUT,
            start_new_session=True,
            env={**os.environ, **self._mark, 'ROS_MASTER_URI': f'http://localhost:{self.port}'})
        self._stack.callback(self._process.wait)

    def __enter__(self):
        """Use it as a context, at whose end nothing is left."""
        return self

    def __exit__(self, *_):
        """End what is left after all."""
        for pid in self.processes():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        self._stack.close()

    @property
    def output(self):
        """What it has printed so far."""
        return os.pread(self._output, 10**6, 0).decode()

    def processes(self):
        """Return the ids of its processes."""
        return marked(self._mark)

    @property
    def pid(self):
        """Process id of the demo itself."""
        return self._process.pid

    def end(self, signals):
        """Send it signals, as fast as possible; those of keys as a terminal does, to its group."""
        for signum in signals:
            if signum in (signal.SIGINT, signal.SIGQUIT):
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(self._process.pid, signum)
            else:
                self._process.send_signal(signum)

    def assert_that_all_ends(self, signum):
        """Wait until there are no processes, and look at the exit status and the port."""
        wait_until_none(self._mark, ENDING_TIME)
        assert self._process.wait() in (-signum, 128 + signum), self.output
        assert 'Traceback' not in self.output
        assert_that_nobody_listens(self.port)


def assert_that_nobody_listens(port):
    """Assert that the next demo can have the port."""
    with socket.socket() as probe:
        assert probe.connect_ex(('localhost', port)) != 0


@pytest.mark.parametrize('moment, signals', EARLY)
def test_nothing_is_left_of_a_demo_that_is_ended_while_it_starts(moment, signals):
    """Ended from its first moment on."""
    with Demo(*FAR) as demo:
        time.sleep(moment)
        demo.end(signals)
        demo.assert_that_all_ends(signals[0])


@pytest.mark.parametrize('moment, signals', DRIVING)
def test_nothing_is_left_of_a_demo_that_is_ended_while_it_drives(moment, signals):
    """The robot neither."""
    with Demo(*FAR) as demo:
        wait_until(lambda: 'of 100.00 m' in demo.output, 60.0, lambda: demo.output)
        time.sleep(moment)
        assert len(demo.processes()) > 4
        assert_loopback_only(demo.pid)
        demo.end(signals)
        demo.assert_that_all_ends(signals[0])


def test_ctrl_c_on_a_terminal_leaves_a_line_for_the_prompt_and_nothing_else():
    """Pressed five times, as learners do."""
    mark = new_mark()
    with hold_port() as port:
        with Terminal(ROOT, {**os.environ, **mark,
                             'ROS_MASTER_URI': f'http://localhost:{port}'}) as terminal:
            terminal.type(' '.join(['./ws', 'demo', *FAR]))
            terminal.wait_for_output(' of 100.00 m', 60.0)
            for _ in range(5):
                terminal.press_ctrl_c()
            assert terminal.wait_for_prompt() == 128 + signal.SIGINT, terminal.output
        wait_until_none(mark, ENDING_TIME)
        assert_that_nobody_listens(port)
    assert terminal.lines[-1] == '', f'no line for the prompt after:\n{terminal.output}'
    assert ' of 100.00 m, ' in terminal.lines[-2], terminal.output
    assert 'Traceback' not in terminal.output
