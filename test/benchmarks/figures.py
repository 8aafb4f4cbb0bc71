"""The figures that ./ws bench measures: a function each, which returns pairs of a value and its limit."""

import contextlib
import sys
import tempfile
import time
from functools import partial
from pathlib import Path

from answers import answering
from geometry_msgs.msg import Twist
from graph import FINE_LOCKSTEP, LOCKSTEP, RING, TIMEOUT, UNPACED, Graph, beside_ring
from nav_msgs.msg import Odometry
from odometry_common.publishing import advertise
from odometry_tests.processes import Process, hold_port, path_of, run
from odometry_tests.scripts import ROOT, load_script
from odometry_tests.tutorial import detector, forget_parameters, simulator
from odometry_tests.waiting import Recorder, wait_for_subscribers, wait_until
from registry import figure, in_slices, in_turns
from worlds import SPEED, BareWorld, RobotWorld, bare_worlds

FOLDER = Path(__file__).parent
LOCKSTEP_RUNS = load_script('sim_turtlebot/test/lockstep_runs.py')
SCRIPTS = {'demo': 'tools/odometry_tools/src/odometry_tools/runs/following.py',
           'simulator': 'sim_turtlebot/script/sim_turtlebot_node.py',
           'detector': 'odom_movement_detector/src/odom_movement_detector.py',
           'mover': 'test_movement/src/test_movement.py'}
ROBOTS, DRIVES, PROCESSES = 50, 1000, 2
SESSIONS = 2 * PROCESSES
MORE_RUNS = 12
PACE_WINDOW = 5.0  # s after each; the machine is not as fast in each second
SWEEP_TIMEOUT = 300.0  # s


@figure('demo from call to prompt', 's', '<=', 1.1)
def demo(options):
    """Compare with a bare roslaunch of as many nodes with the same imports."""
    def run_bare():
        """Tell roslaunch to end once each node has seen a message."""
        scripts = [f'{name}:={ROOT / script}' for name, script in SCRIPTS.items()]
        with hold_port() as port:
            begin = time.perf_counter()
            with Process('roslaunch', '-p', port, FOLDER / 'bare.launch', *scripts, env={
                    'ROS_MASTER_URI': f'http://localhost:{port}', 'ROS_HOSTNAME': 'localhost'}) as process:
                wait_until(lambda: process.stdout.count('seen') == len(SCRIPTS), TIMEOUT,
                           lambda: f'{len(SCRIPTS)} nodes; roslaunch printed:\n{process.output}')
                process.end()
                return time.perf_counter() - begin

    return in_turns(options, lambda: run_ws('demo', '--real-time-factor', '0'), run_bare)


@figure('latency at 20 Hz, median', 'ms', '<=', 1.15)
def latency(options):
    """Compare the way from /odom to /moved_distance with a node of bare rospy that answers each odometry."""
    forget_parameters()
    with detector(), Process(sys.executable, RING, 'detector'), answering('/') as latency_of_ours, \
            answering('/ring/') as latency_of_bare:
        return in_turns(options, latency_of_ours, latency_of_bare)


@figure(f'robot without ROS, {SPEED} m/s', 'simulated s/s', '>=', 0.85)
def robot(options):
    """Compare the simulator's robot, commanded after each odometry, with PyBullet alone."""
    return in_slices(options, RobotWorld().speed, BareWorld().speed)


@figure(f'cost per robot of {ROBOTS} robots', 'ms/simulated s/robot', '<=', 1.1)
def robots(options):
    """Compare each of fifty robots that drive in one simulator with one robot without ROS."""
    alone, command = RobotWorld(), Twist()
    command.linear.x = SPEED
    with Graph('_cmd_vel_timeout:=0', f'_robots:={ROBOTS}', *UNPACED, beside=()) as graph, \
            contextlib.ExitStack() as stack:
        with graph.running():
            for number in range(1, ROBOTS + 1):
                publisher = advertise(f'/robot_{number}/cmd_vel', Twist)
                stack.callback(publisher.unregister)
                wait_for_subscribers(publisher)
                publisher.publish(command)
        return in_slices(options, lambda window: 1e3 / graph.speed(window) / ROBOTS,
                         lambda window: 1e3 / alone.speed(window))


@figure('start to first /odom', 's', '<=', 1.1)
def start(options):
    """Compare the simulator with a bare node with the same imports."""
    def start_simulator():
        forget_parameters()
        with contextlib.closing(Recorder('/odom', Odometry)) as seen:
            begin = time.perf_counter()
            with simulator():
                seen.wait_for(timeout=TIMEOUT)
                return time.perf_counter() - begin

    return in_turns(options, start_simulator, partial(start_bare, path_of('sim_turtlebot', 'sim_turtlebot_node.py')))


def start_bare(script):
    """Start a bare node with a script's imports; return how long (s) it takes to its first message."""
    begin = time.perf_counter()
    with Process(sys.executable, FOLDER / 'bare_node.py', script) as process:
        wait_until(lambda: 'seen' in process.stdout, TIMEOUT, 'a message', period=0.001)
        duration = time.perf_counter() - begin
        process.wait(TIMEOUT)  # it ends by itself, in which rospy must not be interrupted
    return duration


@figure('run of detector and mover in a sweep', 's', '<=', 2.5)
def session(options):
    """Compare 20 simulated seconds of ./ws sweep, on two processors, with the start of a bare node."""
    def run_sweep(seeds):
        return run_ws('sweep', 'odometry_launch', 'movers.launch', '--until', 20, '--seeds', seeds,
                      '--jobs', SESSIONS)

    def one_more_run():
        return (run_sweep(SESSIONS + MORE_RUNS) - run_sweep(SESSIONS)) / MORE_RUNS

    return in_turns(options, one_more_run, partial(start_bare, ROOT / SCRIPTS['mover']))


@figure('./ws check heading', 's', '<=', 25)
def check(options):
    """Compare the check of rotate.py with the start of a bare node."""
    return in_turns(options, lambda: run_ws('check', 'heading', 'rotate_robot', 'rotate.py'),
                    partial(start_bare, path_of('rotate_robot', 'rotate.py')))


def run_ws(*arguments):
    """Run a command of ./ws; return how long (s) it takes."""
    begin = time.perf_counter()
    run(ROOT / 'ws', *arguments, timeout=SWEEP_TIMEOUT)
    return time.perf_counter() - begin


@figure(f'{DRIVES} drives on two processors', 's', '<=', 1.15)
def sweep(options):
    """Compare ./ws sweep with PyBullet stepping as many drives, in as many processes."""
    from odometry_tools.sweep import closed_loop  # the package may be left out

    simulated = closed_loop.run('move', {})['time']
    with bare_worlds(PROCESSES) as speed:
        return in_turns(options, lambda: run_ws('sweep', 'move', '--seeds', DRIVES, '--jobs', PROCESSES), lambda: DRIVES * simulated / speed(PACE_WINDOW))


@figure('graph unpaced', 'simulated s/s', '>=', 0.6)
def unpaced(options):
    """Compare robot, detector and mover as fast as they can with PyBullet alone."""
    with Graph(*UNPACED) as graph:
        return in_slices(options, graph.speed, BareWorld().speed)


@figure('graph in lockstep', 'simulated s/s', '>=', 0.55)
def lockstep(options):
    """Compare robot, detector and mover with bare nodes that step PyBullet, publish and answer."""
    return beside_ring(options, Graph(*LOCKSTEP))


@figure('tf client in lockstep', 'simulated s/s', '>=', 0.157)  # 25 times real time where the ring makes 159
def lockstep_tf(options):
    """Compare a client that drives by tf in a loop, with a clock of 100 Hz, with the same bare nodes."""
    client = partial(Process, sys.executable, LOCKSTEP_RUNS.CLIENTS_FOLDER / 'clients.py', 'tf_listener')
    return beside_ring(options, Graph(*FINE_LOCKSTEP, beside=[client]))


@figure('C++ client in lockstep', 'simulated s/s', '>=', 0.038)  # 6 times real time where the ring makes 159
def lockstep_cpp(options):
    """Compare a client with a loop of ros::Rate, with a clock of 100 Hz, with the same bare nodes."""
    with tempfile.TemporaryDirectory() as folder:
        client = partial(Process, LOCKSTEP_RUNS.compile_client(Path(folder, 'client')), 'rate')
        return beside_ring(options, Graph(*FINE_LOCKSTEP, beside=[client]))
