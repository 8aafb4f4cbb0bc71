"""How soon a node that is started does its work, and how soon one that is told to end is gone."""

import signal
import sys
import time
from contextlib import closing
from pathlib import Path

import rospkg
from measuring import Target, compare, in_turns
from nav_msgs.msg import Odometry
from odometry_launch.process_guard import GuardedProcess
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector, forget_parameters
from odometry_tests.waiting import Recorder

TIMEOUT = 60.0  # s
HERE = Path(__file__).parent
SIMULATOR = Path(rospkg.RosPack().get_path('sim_turtlebot')) / 'script/sim_turtlebot_node.py'


def start(options):
    """Measure from the start of the process to the first /odom."""
    pairs = in_turns(options.runs, start_simulator, start_bare)
    yield compare('start to first /odom', 's', pairs, Target('<=', 1.25))


def end(options):
    """Measure from Ctrl-C to the end of the process; the limit is what rospy needs."""
    pairs = in_turns(
        options.runs, lambda: _end(detector(start=GuardedProcess), 'waiting for odometry'),
        lambda: _end(Process('python3', HERE / 'relay.py', '/question', '/answer'), 'ready'))
    yield compare('end of a node', 's', pairs, Target('<=', 1.25))


def start_simulator(*arguments, topic='/odom'):
    """Start a simulator and return the time (s) to its first message on a topic."""
    forget_parameters()
    with closing(Recorder(topic, Odometry)) as odometry:
        begin = time.perf_counter()
        with Process(sys.executable, SIMULATOR, *arguments):
            odometry.wait_for(timeout=TIMEOUT)
            return time.perf_counter() - begin


def start_bare():
    """Return the time (s) in which a node with the same imports sees a message."""
    begin = time.perf_counter()
    with Process(sys.executable, HERE / 'bare_node.py', SIMULATOR) as process:
        process.wait_for_output('seen', TIMEOUT)
        duration = time.perf_counter() - begin
        process.wait(TIMEOUT)  # it ends by itself, in which rospy must not be interrupted
    return duration


def _end(process, word):
    """Return the time (s) that a node needs to end once it has said a word.

    rospy itself may never end if Ctrl-C comes while it registers a topic.
    """
    with process:
        process.wait_for_output(word, TIMEOUT)
        begin = time.perf_counter()
        process.end(signal.SIGINT)
        return time.perf_counter() - begin
