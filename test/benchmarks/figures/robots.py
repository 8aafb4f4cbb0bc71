"""What each of fifty robots in one simulator costs, beside one robot without ROS."""

import contextlib

from geometry_msgs.msg import Twist
from graph import UNPACED, Graph
from measuring import Target, in_slices
from odometry_common.publishing import advertise
from odometry_tests.waiting import wait_for_subscribers
from worlds import SPEED, RobotWorld

COUNT = 50
NAME, UNIT = f'cost per robot of {COUNT} robots', 'ms/simulated s/robot'
TARGET = Target('<=', 1.2)


def measure(options):
    alone = RobotWorld()
    with Graph('_cmd_vel_timeout:=0', f'_robots:={COUNT}', *UNPACED, movers=False) as graph, \
            _all_driven(graph):
        return in_slices(options, lambda window: 1e3 / graph.speed(window) / COUNT,
                         lambda window: 1e3 / alone.speed(window))


@contextlib.contextmanager
def _all_driven(graph):
    """Have each robot drive for ever."""
    command = Twist()
    command.linear.x = SPEED
    with contextlib.ExitStack() as stack, graph.running():
        for number in range(1, COUNT + 1):
            publisher = advertise(f'/robot_{number}/cmd_vel', Twist)
            stack.callback(publisher.unregister)
            wait_for_subscribers(publisher)
            publisher.publish(command)
        yield
