"""The speed of a ring of bare nodes, which the figures of lockstep are compared with."""

import contextlib
from pathlib import Path

from odometry_common.publishing import advertise
from odometry_tests.links import has_listener
from odometry_tests.processes import Process
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from std_msgs.msg import Float64

RING = Path(__file__).with_name('ring.py')
UNDER_WAY = 1.0  # s of simulated time; lockstep begins with a pause of wall time
TIMEOUT = 30.0  # s of wall time


def beside_ring(options, graph):
    """Measure a Graph, and then a ring, and return pairs of their speeds (simulated s/s).

    Ends the graph first: lockstep would look at the nodes of the ring, too.
    """
    with graph:
        graph.run_until(UNDER_WAY)
        speeds = [graph.speed(options.window) for _ in range(options.runs)]
    with _ring() as ring_speed:
        return [(speed, ring_speed(options.window)) for speed in speeds]


@contextlib.contextmanager
def _ring():
    """Start a ring, and yield a function that returns its speed in a window (s of wall time)."""
    with contextlib.ExitStack() as stack:
        for role in ('robot', 'detector', 'mover'):
            stack.enter_context(Process('python3', RING, role))
        run = advertise('/ring/run', Float64)
        ran = stack.enter_context(contextlib.closing(Recorder('/ring/ran', Float64)))
        wait_for_subscribers(run, timeout=TIMEOUT)
        for topic in ('odom', 'moved_distance', 'cmd_vel', 'ran'):
            wait_until(lambda topic=topic: has_listener(f'/ring/{topic}'), TIMEOUT,
                       f'a subscriber of /ring/{topic}')

        def speed(window):
            ran.clear()
            run.publish(window)
            return ran.wait_for(timeout=TIMEOUT).data

        yield speed
