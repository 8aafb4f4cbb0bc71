"""How fast simulated time can pass, and what CPU time it takes."""

from graph import Graph
from measuring import Target, compare, in_turns
from worlds import BareWorld, RobotWorld

SPEED_UNIT = 'simulated s/s'
CPU_UNIT = 'ms/simulated s'
UNPACED = ['_real_time_factor:=0']
UNDER_WAY = 1.0  # s of simulated time; lockstep begins with a pause of wall time


def robot_without_ros(options):
    """Measure the simulator's robot, commanded after each odometry."""
    robot, bare = RobotWorld(), BareWorld()
    pairs = in_turns(options.runs, lambda: robot.speed(options.window),
                     lambda: bare.speed(options.window))
    yield compare('robot without ROS', SPEED_UNIT, pairs, Target('>=', 0.85))


def graph_unpaced(options):
    """Measure robot, detector and mover, as fast as they can, each against bare stepping."""
    bare = BareWorld()
    with Graph(*UNPACED) as graph:
        graph.run_until(UNDER_WAY, 0.01)
        pairs = in_turns(options.runs, lambda: graph.watch(options.window),
                         lambda: bare.speed(options.window))
    speeds = [(sample.simulated / sample.wall, limit) for sample, limit in pairs]
    # Bare stepping keeps one processor busy all the time.
    cpu = [(1e3 * sample.cpu / sample.simulated, 1e3 / limit) for sample, limit in pairs]
    yield compare('graph unpaced', SPEED_UNIT, speeds, Target('>=', 0.55))
    yield compare('graph unpaced, CPU time', CPU_UNIT, cpu)
