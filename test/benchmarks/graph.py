"""The whole graph, or its robot alone, as processes that are paused between measurements."""

import contextlib
import time

from odometry_tests.links import has_listener
from odometry_tests.pausing import call
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector, forget_parameters, mover, simulator
from odometry_tests.waiting import Recorder, wait_until
from rosgraph_msgs.msg import Clock

UNPACED = '_real_time_factor:=0',
FINE_LOCKSTEP = *UNPACED, '_lockstep:=true'  # its clock ticks at 100 Hz
LOCKSTEP = *FINE_LOCKSTEP, '_clock_rate:=20'
FAR = 1e6  # m; nobody arrives there
TIMEOUT = 30.0  # s of wall time


class Graph:
    """Processes around a simulator; simulated time stands still but for the measurements."""

    def __init__(self, *arguments, movers=True, client=None):
        """Start them; use it as a context.

        :param arguments: for the simulator, such as '_robots:=5'
        :param movers: whether to start the detector and the mover
        :param client: command of a client that drives in their place
        """
        forget_parameters()
        self._stack = contextlib.ExitStack()
        self._stack.enter_context(simulator(*arguments))
        # Nothing may pass before it is measured.
        call('pause_physics')
        if client:
            self._stack.enter_context(Process(*client))
        elif movers:
            self._stack.enter_context(detector())
            self._stack.enter_context(mover(f'_distance:={FAR}'))
            for topic in ('/odom', '/moved_distance', '/cmd_vel'):
                wait_until(lambda topic=topic: has_listener(topic), TIMEOUT,
                           f'a subscriber of {topic}')

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._stack.close()

    @contextlib.contextmanager
    def running(self):
        """Let time pass within this context."""
        call('unpause_physics')
        yield
        call('pause_physics')

    def speed(self, window):
        """Let time pass for `window` s of wall time; return the simulated seconds per second.

        It takes longer if the machine holds the graph up all the while: some simulated time has
        passed.
        """
        with _clock() as clock, self.running():
            clock.wait_for_count(2)  # lockstep has waited for the master, as for each new subscriber
            begin, first = time.perf_counter(), _seconds(clock)
            time.sleep(window)
            passed = wait_until(lambda: max(0.0, _seconds(clock) - first), TIMEOUT,
                                'simulated time to pass')
            return passed / (time.perf_counter() - begin)

    def run_until(self, simulated):
        """Let time pass until `simulated` s."""
        with _clock() as clock, self.running():
            clock.wait_for(lambda message: message.clock.to_sec() >= simulated, TIMEOUT)


@contextlib.contextmanager
def _clock():
    """Record the clock; begin and end while time stands still."""
    with contextlib.closing(Recorder('/clock', Clock)) as clock:
        clock.wait_for_publisher()
        yield clock


def _seconds(clock):
    return clock.last.clock.to_sec()
