"""How long a demo takes, beside a bare roslaunch of as many nodes with the same imports."""

import re
import time
from pathlib import Path

import rosbag
from measuring import Figure, Target, compare, in_turns
from odometry_tests.processes import Process, hold_port
from odometry_tests.waiting import wait_until

ROOT = Path(__file__).resolve().parents[2]
BARE = Path(__file__).with_name('bare.launch')
SCRIPTS = {'demo': 'launch/src/odometry_launch/following.py',
           'simulator': 'sim_turtlebot/script/sim_turtlebot_node.py',
           'detector': 'odom_movement_detector/src/odom_movement_detector.py',
           'mover': 'test_movement/src/test_movement.py'}
TIMEOUT = 60.0  # s
UNIT = 's'
TARGET = Target('<=', 1.25)


def demo(options):
    """Measure a demo from its call to the prompt, and another until the robot moves.

    The first one is as fast as it can be, and in lockstep: its odometry is the same each time.
    """
    runs = in_turns(options.runs, _run_demo, _run_bare)
    yield compare('demo from call to prompt', UNIT,
                  [(duration, limit) for (duration, _), limit in runs], TARGET)
    first, *others = [_odometry(bag) for (_, bag), _ in runs]
    different = sum(other[number] != first[number] for other in others
                    for number in first.keys() & other.keys())
    yield Figure('odometry that differs from the first demo\'s', different, 'messages', 0.0,
                 float('nan'), Target('=', 0, of_value=True))
    yield compare('demo until the robot moves', UNIT,
                  in_turns(options.runs, _start_demo, _start_bare), TARGET)


def _run_demo():
    """Return the time (s) of a demo, and the path of its bag."""
    begin = time.perf_counter()
    with Process(ROOT / 'ws', 'demo', '--real-time-factor', '0') as process:
        process.wait(TIMEOUT)
        duration = time.perf_counter() - begin
    return duration, ROOT / re.search(r'^picture +(.*)/run\.png$', process.stdout,
                                      re.MULTILINE).group(1) / 'run.bag'


def _run_bare():
    """Return the time (s) until all is over, if roslaunch is told to end once the nodes do."""
    with hold_port() as port:
        begin = time.perf_counter()
        with _bare(port) as process:
            _wait_for_nodes(process)
            process.end()
            return time.perf_counter() - begin


def _start_demo():
    """Return the time (s) from the call to the first line about a robot that moves."""
    begin = time.perf_counter()
    with Process(ROOT / 'ws', 'demo') as process:
        process.wait_for_output(' of 2.00 m', TIMEOUT)
        return time.perf_counter() - begin


def _start_bare():
    """Return the time (s) from the call until each node has seen its message."""
    with hold_port() as port:
        begin = time.perf_counter()
        with _bare(port) as process:
            _wait_for_nodes(process)
            return time.perf_counter() - begin


def _bare(port):
    scripts = [f'{name}:={ROOT / script}' for name, script in SCRIPTS.items()]
    return Process('roslaunch', '-p', port, BARE, *scripts,
                   env={'ROS_MASTER_URI': f'http://localhost:{port}', 'ROS_HOSTNAME': 'localhost'})


def _wait_for_nodes(process):
    wait_until(lambda: process.stdout.count('seen') == len(SCRIPTS), TIMEOUT,
               lambda: f'{len(SCRIPTS)} nodes; roslaunch printed:\n{process.output}')


def _odometry(path):
    """Return the messages in a bag, as they were sent, by their numbers."""
    with rosbag.Bag(str(path)) as bag:
        return {int.from_bytes(data[:4], 'little'): data
                for _, (_, data, *_), _ in bag.read_messages('/odom', raw=True)}
