"""Run a tutorial with a simulated robot, show its progress, and report the result.

Its parent ends it by SIGTERM, which Python obeys at any moment without a message; the nodes end
with it.
"""

import logging
import math
import os
import signal
import sys
import time

import rospy

from odometry_launch.folders import RUNS
from odometry_launch.graph import DemoError, Graph
from odometry_launch.logs import find_place_for_logs
from odometry_launch.monitors import MoveMonitor, RotateMonitor
from odometry_launch.options import launch_arguments, nodes_that_end, parse
from odometry_launch.output import REWRITE, complain, forget_output
from odometry_launch.page import Page
from odometry_launch.recording import Recording
from odometry_launch.silence import Silence

MONITORS = {'move': MoveMonitor, 'rotate': RotateMonitor}


def main():
    """Exit 0 only if the robot did what it was told and stands."""
    options = parse(sys.argv[1:])
    try:
        status = 0 if _run(options) else 1
        sys.stdout.flush()
    except BrokenPipeError:
        status = 128 + signal.SIGPIPE
    except (DemoError, OSError) as error:
        status = 1
        complain(error)
    forget_output()
    sys.exit(status)


def _run(options):
    # The user need not know that rospy cannot write to its log.
    logging.raiseExceptions = False
    find_place_for_logs()
    page = Page() if options.view else None
    launch_file, arguments = launch_arguments(options, page.port if page else None)
    with Graph(launch_file, arguments, nodes_that_end(options)) as graph:
        if graph.unusual_address:
            print('rostopic in another terminal: '
                  f'export ROS_MASTER_URI={graph.unusual_address}', flush=True)
        complaint = _follow(options, graph, page)
        if page and sys.stdout.isatty():
            page.stay(graph)
    return not complaint


def _follow(options, graph, page):
    """Follow the robot to its end, print the result, and return a complaint or None."""
    graph.wait_for(_join, 'the demo does not become a node')
    recording = _record()
    monitor = MONITORS[options.tutorial](options)
    graph.wait_for(monitor.started, 'the robot does not begin to move')
    wall_start = time.monotonic()
    if page:
        page.announce(graph)
    _watch(monitor, graph, Silence(options.real_time_factor))
    wall_time = time.monotonic() - wall_start
    summary, complaint = monitor.result()
    print(f'{summary}\ntime            {monitor.duration:.1f} s simulated, {wall_time:.1f} s real',
          flush=True)
    picture = recording and recording.finish()
    if picture:
        print(f'picture         {os.path.relpath(picture)}', flush=True)
    if complaint:
        complain(complaint)
    return complaint


def _join():
    rospy.init_node('demo', anonymous=True, disable_signals=True)
    return True


def _record():
    """Start a recording; without a place for it the demo goes on."""
    try:
        return Recording(RUNS)
    except OSError as error:
        complain(f'no recording: {error}')
        return None


def _watch(monitor, graph, silence):
    line = Line()
    while monitor.end is None:
        graph.check()
        silence.look(monitor.now)
        line.show(monitor.progress(), monitor.now)
        time.sleep(0.1)
    line.finish(monitor.progress())


class Line:
    """One line that is rewritten on a terminal; elsewhere a line every two simulated seconds."""

    PERIOD = 2.0

    def __init__(self):
        """Find out where the output goes."""
        self._live = sys.stdout.isatty()
        self._next = -math.inf

    def show(self, text, now):
        """Show the text, at `now` simulated seconds."""
        if self._live:
            print(f'{REWRITE}{text}', end='', flush=True)
        elif now >= self._next:
            self._next = now + self.PERIOD
            print(text, flush=True)

    def finish(self, text):
        """Leave the text on the screen."""
        print(f'{REWRITE}{text}' if self._live else text, flush=True)
