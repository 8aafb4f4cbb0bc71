"""What many robots cost in one simulator."""

import rospy
from geometry_msgs.msg import Twist
from graph import Graph
from measuring import Figure, Target, compare, in_turns
from odometry_tests.waiting import wait_for_subscribers
from speed import CPU_UNIT, SPEED_UNIT, UNPACED
from start import start_simulator
from worlds import SPEED, BareWorld, RobotWorld

COUNTS = (1, 5, 20, 50)
COST_UNIT = 'ms/simulated s/robot'


def many_robots(options):
    """Measure speed, memory, start and the cost per robot of several crowds."""
    costs = {}
    for count in COUNTS:
        *figures, costs[count] = _crowd(options, count)
        yield from figures
    few = costs[COUNTS[1]]
    for count, cost in costs.items():
        target = Target('<=', 1.2) if count == COUNTS[-1] else None
        yield Figure(f'cost per robot of {_robots(count)}', cost, COST_UNIT, few, cost / few, target)


def _crowd(options, count):
    """Return the figures of so many robots, and at last the cost of one of them (ms)."""
    label = _robots(count)
    bare, robots = BareWorld(count), RobotWorld(count)
    yield compare(f'robot without ROS, {label}', SPEED_UNIT, in_turns(
        options.runs, lambda: robots.speed(options.window), lambda: bare.speed(options.window)))
    with Graph('_cmd_vel_timeout:=0', f'_robots:={count}', *UNPACED, movers=False) as graph:
        _drive_all(graph, count)
        pairs = in_turns(options.runs, lambda: graph.watch(options.window),
                         lambda: bare.speed(options.window))
        memory = graph.memory()
    speed = compare(f'simulator, {label}', SPEED_UNIT,
                    [(sample.simulated / sample.wall, limit) for sample, limit in pairs])
    yield speed
    yield compare(f'simulator, {label}, CPU time', CPU_UNIT,
                  [(1e3 * sample.cpu / sample.simulated, 1e3 / limit) for sample, limit in pairs])
    yield Figure(f'memory, {label}', memory, 'MB', memory, 1.0)
    topic = '/odom' if count == 1 else f'/robot_{count}/odom'
    seconds = [start_simulator(f'_robots:={count}', topic=topic) for _ in range(options.runs)]
    yield compare(f'start to first /odom, {label}', 's', [(each, each) for each in seconds])
    yield 1e3 / speed.value / count


def _drive_all(graph, count):
    """Have each robot drive for ever."""
    command = Twist()
    command.linear.x = SPEED
    with graph.running():
        for number in range(1, count + 1):
            topic = '/cmd_vel' if count == 1 else f'/robot_{number}/cmd_vel'
            publisher = rospy.Publisher(topic, Twist, queue_size=1, latch=True)
            wait_for_subscribers(publisher)
            publisher.publish(command)


def _robots(count):
    return '1 robot' if count == 1 else f'{count} robots'
