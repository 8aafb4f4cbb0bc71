"""Processes whose speed is measured: the whole graph or its robot alone, and a ring of bare nodes."""

import contextlib
import time
from functools import partial
from pathlib import Path

from odometry_common.publishing import advertise
from odometry_tests.links import has_listener
from odometry_tests.pausing import call
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector, forget_parameters, mover, simulator
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Float64

UNPACED = '_real_time_factor:=0',
FINE_LOCKSTEP = *UNPACED, '_lockstep:=true'  # its clock ticks at 100 Hz
LOCKSTEP = *FINE_LOCKSTEP, '_clock_rate:=20'
TUTORIAL = detector, partial(mover, '_distance:=1000000')  # m; nobody arrives there
TIMEOUT = 30.0  # s of wall time
RING = Path(__file__).with_name('ring.py')


class Graph(contextlib.ExitStack):
    """Processes around a simulator; simulated time stands still but for the measurements."""

    def __init__(self, *arguments, beside=TUTORIAL):
        """Start them; they end with the context.

        :param arguments: for the simulator, such as '_robots:=5'
        :param beside: functions that start the nodes beside it
        """
        super().__init__()
        forget_parameters()
        self.enter_context(simulator(*arguments))
        # Nothing may pass before it is measured.
        call('pause_physics')
        for start in beside:
            self.enter_context(start())
        if beside is TUTORIAL:
            wait_for_listeners('/odom', '/moved_distance', '/cmd_vel')

    @contextlib.contextmanager
    def running(self):
        call('unpause_physics')
        yield
        call('pause_physics')

    def speed(self, window):
        """Let time pass for `window` s of wall time; return the simulated seconds per second.

        It takes longer if the machine holds the graph up all the while: some simulated time has
        passed.
        """
        def now():
            return clock.last.clock.to_sec()

        with contextlib.closing(Recorder('/clock', Clock)) as clock:
            clock.wait_for_publisher()
            with self.running():
                clock.wait_for_count(2)  # lockstep has waited for the master, as for each new subscriber
                begin, first = time.perf_counter(), now()
                time.sleep(window)
                passed = wait_until(lambda: max(0.0, now() - first), TIMEOUT, 'simulated time to pass')
                return passed / (time.perf_counter() - begin)


def beside_ring(options, graph):
    """Measure a Graph, and then a ring, and return pairs of their speeds (simulated s/s).

    Ends the graph first: lockstep would look at the nodes of the ring, too.
    """
    with graph:
        graph.speed(options.window)  # lockstep begins with a pause of wall time
        speeds = [graph.speed(options.window) for _ in range(options.runs)]
    with _ring() as ring_speed:
        return [(speed, ring_speed(options.window)) for speed in speeds]


@contextlib.contextmanager
def _ring():
    with contextlib.ExitStack() as stack:
        for role in 'robot', 'detector', 'mover':
            stack.enter_context(Process('python3', RING, role))
        run = advertise('/ring/run', Float64)
        ran = stack.enter_context(contextlib.closing(Recorder('/ring/ran', Float64)))
        wait_for_subscribers(run, timeout=TIMEOUT)
        wait_for_listeners('/ring/odom', '/ring/moved_distance', '/ring/cmd_vel', '/ring/ran')

        def speed(window):
            ran.clear()
            run.publish(window)
            return ran.wait_for(timeout=TIMEOUT).data

        yield speed


def wait_for_listeners(*topics):
    for topic in topics:
        wait_until(lambda topic=topic: has_listener(topic), TIMEOUT, f'a subscriber of {topic}')
