"""Robot, detector and mover in lockstep, beside a ring of bare nodes that pass the same messages on.

The nodes of the ring step PyBullet, publish and answer, and do nothing else.
"""

import contextlib
from pathlib import Path

from graph import LOCKSTEP, TIMEOUT, UNDER_WAY, Graph
from measuring import SPEED_UNIT, Target, in_slices
from odometry_common.publishing import advertise
from odometry_tests.links import has_listener
from odometry_tests.processes import Process
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from std_msgs.msg import Float64

NAME, UNIT, TARGET = 'graph in lockstep', SPEED_UNIT, Target('>=', 0.35)
RING = Path(__file__).parents[1] / 'ring.py'


def measure(options):
    """Return pairs of a speed and the ring's."""
    with Graph(*LOCKSTEP) as graph, _ring() as ring_speed:
        graph.run_until(UNDER_WAY)
        return in_slices(options, graph.speed, ring_speed)


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
