"""How fast simulated time can pass, and what CPU time it takes."""

import rospy
from graph import Graph
from measuring import Target, compare, in_slices, in_turns
from worlds import BareWorld, RobotWorld

SPEED_UNIT = 'simulated s/s'
CPU_UNIT = 'ms/simulated s'
UNPACED = ['_real_time_factor:=0']
UNDER_WAY = 1.0  # s of simulated time; lockstep begins with a pause of wall time


def robot_without_ros(options):
    """Measure the simulator's robot, commanded after each odometry."""
    robot, bare = RobotWorld(), BareWorld()
    pairs = in_slices(options, robot.speed, bare.speed)
    yield compare('robot without ROS', SPEED_UNIT, pairs, Target('>=', 0.85))


def graph_unpaced(options):
    """Measure robot, detector and mover, as fast as they can, each against bare stepping."""
    bare = BareWorld()
    with Graph(*UNPACED) as graph:
        graph.run_until(UNDER_WAY, 0.01)
        pairs = in_slices(options, graph.watch, bare.speed)
    speeds = [(sample.simulated / sample.wall, limit) for sample, limit in pairs]
    # Bare stepping keeps one processor busy all the time.
    cpu = [(1e3 * sample.cpu / sample.simulated, 1e3 / limit) for sample, limit in pairs]
    yield compare('graph unpaced', SPEED_UNIT, speeds, Target('>=', 0.55))
    yield compare('graph unpaced, CPU time', CPU_UNIT, cpu)


def graph_with_scan(options):
    """Measure the unpaced graph with the default scan and somebody who takes it, against real time."""
    with Graph(*UNPACED, '_scan:=true') as graph:
        subscriber = rospy.Subscriber('/scan', rospy.AnyMsg)
        graph.run_until(UNDER_WAY, 0.01)
        samples = [graph.watch(options.window) for _ in range(options.runs)]
        subscriber.unregister()
    yield compare('graph unpaced, with a scan', SPEED_UNIT,
                  [(sample.simulated / sample.wall, 1.0) for sample in samples],
                  Target('>=', 20))


def clock_ticks(options):
    """Measure the CPU time of the graph at real time, against a clock that ticks with the odometry."""
    pairs = in_turns(options.runs, lambda: _cpu_time(options.window),
                     lambda: _cpu_time(options.window, '_clock_rate:=20'))
    yield compare('graph at real time, CPU time', CPU_UNIT, pairs)


def _cpu_time(window, *arguments):
    with Graph(*arguments) as graph:
        graph.run_until(UNDER_WAY, 0.1)
        sample = graph.watch(window)
    return 1e3 * sample.cpu / sample.simulated
