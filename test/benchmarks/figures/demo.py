"""A demo from its call to the prompt, beside a bare roslaunch of as many nodes with the same imports."""

import time
from pathlib import Path

from measuring import Target, in_turns
from odometry_tests.processes import Process, hold_port
from odometry_tests.scripts import ROOT
from odometry_tests.waiting import wait_until

NAME, UNIT, TARGET = 'demo from call to prompt', 's', Target('<=', 1.25)
BARE = Path(__file__).parents[1] / 'bare.launch'
SCRIPTS = {'demo': 'launch/src/odometry_launch/following.py',
           'simulator': 'sim_turtlebot/script/sim_turtlebot_node.py',
           'detector': 'odom_movement_detector/src/odom_movement_detector.py',
           'mover': 'test_movement/src/test_movement.py'}
TIMEOUT = 60.0  # s


def measure(options):
    return in_turns(options, _run_demo, _run_bare)


def _run_demo():
    begin = time.perf_counter()
    with Process(ROOT / 'ws', 'demo', '--real-time-factor', '0') as process:
        process.wait(TIMEOUT)
    return time.perf_counter() - begin


def _run_bare():
    """Return the time (s) until all is over: roslaunch is told to end once each node has seen a message."""
    scripts = [f'{name}:={ROOT / script}' for name, script in SCRIPTS.items()]
    with hold_port() as port:
        begin = time.perf_counter()
        with Process('roslaunch', '-p', port, BARE, *scripts,
                     env={'ROS_MASTER_URI': f'http://localhost:{port}',
                          'ROS_HOSTNAME': 'localhost'}) as process:
            wait_until(lambda: process.stdout.count('seen') == len(SCRIPTS), TIMEOUT,
                       lambda: f'{len(SCRIPTS)} nodes; roslaunch printed:\n{process.output}')
            process.end()
            return time.perf_counter() - begin
