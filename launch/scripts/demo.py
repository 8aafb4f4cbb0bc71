#!/usr/bin/env python3
"""Drive a simulated TurtleBot 2 two metres and show how it goes."""

import argparse
import math
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
from urllib.parse import urlparse

import rosgraph
import rospy
from nav_msgs.msg import Odometry
from std_msgs.msg import Float64

START_TIMEOUT = 30.0  # s, for the nodes to come up and the robot to begin
STOP_TIMEOUT = 10.0  # s, for the nodes to end
MAX_SPEED = 0.7  # m/s, TurtleBot 2
REACTION_TIME = 0.1  # s; the robot may go on for so long once it has arrived
BRAKING = 2.8  # m/s^2, measured on the simulated robot
REST_SPEED = 1e-3  # m/s
BAR_WIDTH = 30


class DemoError(RuntimeError):
    """The demo cannot go on; the message is one line for the user."""


def main():
    """Run the demo; exit 0 only if the robot went the distance and stands."""
    options = _parse(sys.argv[1:])
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    with tempfile.TemporaryFile('w+') as log:
        try:
            with Graph(options, log) as graph:
                drive = Drive(options, graph)
                drive.watch()
            sys.exit(0 if drive.summarise() else 1)
        except DemoError as error:
            log.seek(0)
            print(f'{log.read()}demo: {error}', file=sys.stderr)
            sys.exit(1)
        except KeyboardInterrupt:
            sys.exit(128 + signal.SIGINT)


def _parse(arguments):
    parser = argparse.ArgumentParser(prog='./ws demo', description=__doc__)
    parser.add_argument('--distance', type=_number(1e-3, 1000), default=2.0, metavar='M',
                        help='where to stop (m; default: %(default)s)')
    parser.add_argument('--speed', type=_number(-MAX_SPEED, MAX_SPEED), default=0.1, metavar='M/S',
                        help='how fast (m/s; negative drives backwards; default: %(default)s)')
    parser.add_argument('--real-time-factor', type=_number(0, 100), default=1.0, metavar='N',
                        help='simulated seconds per second; 0: as fast as possible '
                             '(default: %(default)s)')
    parser.add_argument('--gui', action='store_true', help="open PyBullet's window")
    options = parser.parse_args(arguments)
    if abs(options.speed) < 0.001:
        parser.error('argument --speed: 0.001 m/s is the slowest')
    return options


def _number(lowest, highest):
    def parse(text):
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not lowest <= value <= highest:
            raise argparse.ArgumentTypeError(
                f'{text!r} is not a number from {lowest:g} to {highest:g}')
        return value
    return parse


class Graph:
    """The robot, the detector and the mover, as roslaunch starts them."""

    def __init__(self, options, log):
        """Choose a master of our own."""
        self._options = options
        self._log = log
        self._process = None

    def __enter__(self):
        """Start everything."""
        port = _free_port()
        os.environ['ROS_MASTER_URI'] = f'http://localhost:{port}'
        arguments = {
            'distance': self._options.distance,
            'speed': self._options.speed,
            'gui': str(self._options.gui).lower(),
            'real_time_factor': self._options.real_time_factor,
        }
        self._process = subprocess.Popen(
            ['roslaunch', '-p', str(port), 'odometry_launch', 'move_two_meters.launch',
             *(f'{name}:={value}' for name, value in arguments.items())],
            stdout=self._log, stderr=subprocess.STDOUT, start_new_session=True)
        return self

    def __exit__(self, *_):
        """End everything."""
        self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(STOP_TIMEOUT)
        except subprocess.TimeoutExpired:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()

    def check(self):
        """Raise DemoError if something has ended by itself."""
        if self._process.poll() is not None:
            raise DemoError('the simulation has ended before the robot arrived')


def _free_port():
    """Return the usual port if nobody has it, so that rostopic finds the demo, else another."""
    usual = urlparse(os.environ.get('ROS_MASTER_URI', '')).port or rosgraph.DEFAULT_MASTER_PORT
    for port in (usual, 0):
        with socket.socket() as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind(('localhost', port))
            except OSError:
                continue
            return probe.getsockname()[1]
    raise DemoError('there is no free port for a ROS master')


class Drive:
    """What the demo sees of the drive, from the topics alone."""

    def __init__(self, options, graph):
        """Connect to the graph."""
        self._options = options
        self._graph = graph
        self._moved = 0.0
        self._truth = None
        self._start = None
        self._arrival = None
        self._line = Line()
        self._wait_for(self._master_is_up, 'the ROS master does not answer')
        # The master is up a moment before it says whose clock rules.
        self._wait_for(lambda: rosgraph.Master('/demo').hasParam('/sim_turtlebot/gui'),
                       'the launch file has not been loaded')
        rospy.init_node('demo', anonymous=True, disable_signals=True)
        rospy.Subscriber('base_pose_ground_truth', Odometry, self._on_truth)
        rospy.Subscriber('moved_distance', Float64, self._on_moved)

    def watch(self):
        """Show the drive until the robot has arrived and stands."""
        self._wait_for(lambda: self._moved > 0, 'the robot does not begin to move')
        wall_start = time.monotonic()
        while not self._stands():
            self._graph.check()
            self._line.show(self._progress(), self._truth.header.stamp.to_sec())
            time.sleep(0.1)
        self._line.finish(self._progress())
        self._wall_time = time.monotonic() - wall_start

    def summarise(self):
        """Print what happened; tell whether it is what was asked for."""
        wanted = self._options.distance
        speed = abs(self._options.speed)
        allowed = wanted + speed * REACTION_TIME + speed**2 / (2 * BRAKING)
        true_distance = self._true_distance()
        simulated = (self._arrival - self._start.header.stamp).to_sec()
        print(f'moved distance  {self._moved:.3f} m, summed from /odom\n'
              f'true distance   {true_distance:.3f} m, in the simulated world\n'
              f'time            {simulated:.1f} s simulated, {self._wall_time:.1f} s real')
        good = all(wanted <= value <= allowed for value in (self._moved, true_distance))
        if not good:
            print(f'demo: not between {wanted:.3f} and {allowed:.3f} m', file=sys.stderr)
        return good

    def _progress(self):
        moved, wanted = self._moved, self._options.distance
        done = min(BAR_WIDTH, int(BAR_WIDTH * moved / wanted))
        elapsed = (self._truth.header.stamp - self._start.header.stamp).to_sec()
        return (f'[{"=" * done:{BAR_WIDTH}}] {moved:.2f} of {wanted:.2f} m, '
                f'{self._truth.twist.twist.linear.x:.2f} m/s, {elapsed:.1f} s')

    def _stands(self):
        return self._moved >= self._options.distance and self._speed() < REST_SPEED

    def _speed(self):
        linear = self._truth.twist.twist.linear
        return math.hypot(linear.x, linear.y)

    def _true_distance(self):
        start, end = self._start.pose.pose.position, self._truth.pose.pose.position
        return math.hypot(end.x - start.x, end.y - start.y)

    def _on_truth(self, message):
        self._truth = message
        if self._start is None:
            self._start = message
        if self._arrival is None and self._stands():
            self._arrival = message.header.stamp

    def _on_moved(self, message):
        self._moved = message.data

    def _master_is_up(self):
        return rosgraph.is_master_online()

    def _wait_for(self, condition, complaint):
        end = time.monotonic() + START_TIMEOUT
        while not condition():
            self._graph.check()
            if time.monotonic() > end:
                raise DemoError(f'{complaint} within {START_TIMEOUT:g} s')
            time.sleep(0.02)


class Line:
    """One line that is rewritten on a terminal; elsewhere a line every two seconds."""

    PERIOD = 2.0  # simulated seconds

    def __init__(self):
        """Find out where the output goes."""
        self._live = sys.stdout.isatty()
        self._next = -math.inf

    def show(self, text, now):
        """Show the text, at `now` seconds."""
        if self._live:
            print(f'\r\033[K{text}', end='', flush=True)
        elif now >= self._next:
            self._next = now + self.PERIOD
            print(text, flush=True)

    def finish(self, text):
        """Leave the text on the screen."""
        print(f'\r\033[K{text}' if self._live else text, flush=True)


if __name__ == '__main__':
    main()
