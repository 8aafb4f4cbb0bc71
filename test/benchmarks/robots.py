"""What many robots cost in one simulator."""

import contextlib

from geometry_msgs.msg import Twist
from graph import Graph
from measuring import Target, compare, in_slices, in_turns
from odometry_common.publishing import advertise
from odometry_tests.waiting import wait_for_subscribers
from speed import CPU_UNIT, SPEED_UNIT, UNPACED
from start import start_bare, start_simulator
from worlds import SPEED, BareWorld, RobotWorld

COUNTS = (1, 10, 50)
COST_UNIT = 'ms/simulated s/robot'


def many_robots(options):
    """Measure speed, start and the cost per robot of several crowds."""
    options = options._replace(window=options.window / 2)  # for there are many figures
    alone = RobotWorld()
    for count in COUNTS:
        yield from _crowd(options, count, alone)


def _crowd(options, count, alone):
    """Yield the figures of so many robots; `alone` is one without ROS."""
    label = robots(count)
    bare, world = BareWorld(count), RobotWorld(count)
    yield compare(f'robot without ROS, {label}', SPEED_UNIT,
                  in_slices(options, world.speed, bare.speed))
    with Graph('_cmd_vel_timeout:=0', f'_robots:={count}', *UNPACED, movers=False) as graph, \
            _all_driven(graph, count):
        pairs = in_slices(options, graph.watch,
                          lambda window: (bare.speed(window), alone.speed(window)))
    yield compare(f'simulator, {label}', SPEED_UNIT,
                  [(sample.simulated / sample.wall, limit) for sample, (limit, _) in pairs])
    yield compare(f'simulator, {label}, CPU time', CPU_UNIT, [
        (1e3 * sample.cpu / sample.simulated, 1e3 / limit) for sample, (limit, _) in pairs])
    yield compare(f'cost per robot of {label}', COST_UNIT, [
        (1e3 * sample.wall / sample.simulated / count, 1e3 / limit)
        for sample, (_, limit) in pairs], Target('<=', 1.2) if count == COUNTS[-1] else None)
    topic = '/odom' if count == 1 else f'/robot_{count}/odom'
    yield compare(f'start to first /odom, {label}', 's', in_turns(
        options.runs, lambda: start_simulator(f'_robots:={count}', topic=topic), start_bare))


@contextlib.contextmanager
def _all_driven(graph, count):
    """Have each robot drive for ever."""
    command = Twist()
    command.linear.x = SPEED
    topics = ['/cmd_vel' if count == 1 else f'/robot_{number}/cmd_vel'
              for number in range(1, count + 1)]
    publishers = [advertise(topic, Twist) for topic in topics]
    with graph.running():
        for publisher in publishers:
            wait_for_subscribers(publisher)
            publisher.publish(command)
    yield
    for publisher in publishers:
        publisher.unregister()


def robots(count):
    """Return in words how many robots."""
    return '1 robot' if count == 1 else f'{count} robots'
