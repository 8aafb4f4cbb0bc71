"""How fast the graph is in lockstep, beside a ring of bare nodes that step and pass messages on."""

import contextlib
from pathlib import Path

from graph import Graph
from measuring import Target, compare, in_slices
from odometry_common.publishing import advertise
from odometry_tests.links import has_listener
from odometry_tests.processes import Process
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from speed import CPU_UNIT, SPEED_UNIT, UNDER_WAY, UNPACED
from std_msgs.msg import Float64

LOCKSTEP = [*UNPACED, '_lockstep:=true', '_clock_rate:=20']
RING = Path(__file__).with_name('ring.py')
TIMEOUT = 30.0  # s


def graph_in_lockstep(options):
    """Measure robot, detector and mover, where the robot waits for each command."""
    with Graph(*LOCKSTEP) as graph, _ring() as ring_speed:
        graph.run_until(UNDER_WAY, 0.01)
        pairs = in_slices(options, graph.watch, ring_speed)
    yield compare('graph in lockstep', SPEED_UNIT,
                  [(sample.simulated / sample.wall, limit) for sample, limit in pairs],
                  Target('>=', 0.9))
    yield compare('graph in lockstep, CPU time', CPU_UNIT,
                  [(1e3 * sample.cpu / sample.simulated, 1e3 / limit) for sample, limit in pairs])


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
