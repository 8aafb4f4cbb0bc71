"""The whole graph, or its robot alone, in processes of their own, quiet until it is measured."""

import contextlib
import threading
import time

import psutil
import rospy
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.links import has_listener
from odometry_tests.pausing import call
from odometry_tests.tutorial import detector, forget_parameters, mover, simulator
from odometry_tests.waiting import wait_until
from rosgraph_msgs.msg import Clock

UNPACED = '_real_time_factor:=0',
FINE_LOCKSTEP = *UNPACED, '_lockstep:=true'  # its clock ticks at 100 Hz
LOCKSTEP = *FINE_LOCKSTEP, '_clock_rate:=20'
UNDER_WAY = 1.0  # s of simulated time; lockstep begins with a pause of wall time
FAR = 1e6  # m; nobody arrives there
TIMEOUT = 30.0  # s of wall time
MEGABYTE = 2**20


class Graph:
    """Processes around a simulator; simulated time stands still but for the measurements."""

    def __init__(self, *arguments, movers=True, distance=FAR):
        """Start them; use it as a context.

        :param arguments: for the simulator, such as '_robots:=5'
        :param movers: whether to start the detector and the mover, which drives so far (m)
        """
        forget_parameters()
        self._stack = contextlib.ExitStack()
        self._processes = [self._stack.enter_context(simulator(*arguments, start=GuardedProcess))]
        # Nothing may pass before it is measured.
        call('pause_physics')
        if movers:
            for node in (detector(start=GuardedProcess),
                         mover(f'_distance:={distance}', start=GuardedProcess)):
                self._processes.append(self._stack.enter_context(node))
            for topic in ('/odom', '/moved_distance', '/cmd_vel'):
                wait_until(lambda topic=topic: has_listener(topic), TIMEOUT,
                           f'a subscriber of {topic}')

    def __enter__(self):
        """Use it as a context."""
        return self

    def __exit__(self, *_):
        """End all processes."""
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
        with self.running():
            begin, simulated = time.perf_counter(), _now()
            time.sleep(window)
            passed = wait_until(lambda: max(0.0, _now() - simulated), TIMEOUT,
                                'simulated time to pass')
            return passed / (time.perf_counter() - begin)

    def run_until(self, simulated, look_every=0.01):
        """Let time pass until `simulated` s; look at the clock every so many s of wall time."""
        with self.running():
            while _now() < simulated:
                time.sleep(look_every)

    def memory(self):
        """Return the resident memory of all processes (MB)."""
        return sum(psutil.Process(process.pid).memory_info().rss
                   for process in self._processes) / MEGABYTE


def _now():
    """Return the simulated time (s), from a subscriber that slows nobody down afterwards."""
    heard, times = threading.Event(), []

    def on_clock(message):
        times.append(message.clock.to_sec())
        heard.set()

    subscriber = rospy.Subscriber('/clock', Clock, on_clock, tcp_nodelay=True)
    try:
        if not heard.wait(TIMEOUT):
            raise TimeoutError(f'no message on /clock within {TIMEOUT:g} s')
    finally:
        subscriber.unregister()
    return times[-1]
