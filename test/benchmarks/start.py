"""How soon a simulator that is started says where the robot is."""

import sys
import time
from pathlib import Path

import rospkg
from measuring import Target, compare, in_turns
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process
from odometry_tests.tutorial import forget_parameters
from odometry_tests.waiting import Recorder

TIMEOUT = 60.0  # s
BARE_START = Path(__file__).with_name('bare_start.py')


def start(options):
    """Measure from the start of the process to the first /odom."""
    pairs = in_turns(options.runs, start_simulator, start_bare)
    yield compare('start to first /odom', 's', pairs, Target('<=', 1.5))


def start_simulator(*arguments, topic='/odom'):
    """Start a simulator and return the time (s) to its first message on a topic."""
    forget_parameters()
    script = Path(rospkg.RosPack().get_path('sim_turtlebot')) / 'script/sim_turtlebot_node.py'
    odometry = Recorder(topic, Odometry)
    begin = time.perf_counter()
    with Process(sys.executable, script, *arguments):
        odometry.wait_for(timeout=TIMEOUT)
        return time.perf_counter() - begin


def start_bare():
    """Return the time (s) that Python, rospy and PyBullet need by themselves."""
    begin = time.perf_counter()
    with Process(sys.executable, BARE_START) as process:
        process.wait_for_output('ready', TIMEOUT)
        return time.perf_counter() - begin
