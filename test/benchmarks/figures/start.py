"""From the start of the simulator to its first /odom, beside a bare node with the same imports."""

import sys
import time
from contextlib import closing
from pathlib import Path

from measuring import Target, in_turns
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process, path_of
from odometry_tests.tutorial import forget_parameters, simulator
from odometry_tests.waiting import Recorder, wait_until

NAME, UNIT, TARGET = 'start to first /odom', 's', Target('<=', 1.25)
BARE = Path(__file__).parents[1] / 'bare_node.py'
TIMEOUT = 60.0  # s


def measure(options):
    return in_turns(options, _start_simulator, _start_bare)


def _start_simulator():
    forget_parameters()
    with closing(Recorder('/odom', Odometry)) as odometry:
        begin = time.perf_counter()
        with simulator():
            odometry.wait_for(timeout=TIMEOUT)
            return time.perf_counter() - begin


def _start_bare():
    script = path_of('sim_turtlebot', 'sim_turtlebot_node.py')
    begin = time.perf_counter()
    with Process(sys.executable, BARE, script) as process:
        wait_until(lambda: 'seen' in process.stdout, TIMEOUT, 'a message', period=0.001)
        duration = time.perf_counter() - begin
        process.wait(TIMEOUT)  # it ends by itself, in which rospy must not be interrupted
    return duration
