"""Run a tutorial with a simulated robot, show how it goes, and tell how it went."""

import math
import os
import signal
import sys
import time
from pathlib import Path

import rospy

from odometry_launch import page
from odometry_launch.graph import DemoError, Graph
from odometry_launch.options import launch_arguments, parse
from odometry_launch.recording import Recording
from odometry_launch.shows import MoveShow, RotateShow

RUNS = Path(__file__).resolve().parents[3] / 'runs'
SHOWS = {'move': MoveShow, 'rotate': RotateShow}


def main():
    """Exit 0 only if the robot did what it was told and stands."""
    options = parse(sys.argv[1:])
    for signum in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(signum, lambda signum, _: sys.exit(128 + signum))
    try:
        sys.exit(0 if _run(options) else 1)
    except DemoError as error:
        print(f'demo: {error}', file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)


def _run(options):
    if options.view:
        page.check_port()
    with Graph(*launch_arguments(options)) as graph:
        complaint = _show(options, graph)
        if options.view and sys.stdout.isatty():
            page.stay(graph)
    return not complaint


def _show(options, graph):
    """Follow the robot to its end, tell how it went, and return a complaint or None."""
    rospy.init_node('demo', anonymous=True, disable_signals=True)
    recording = _record()
    show = SHOWS[options.tutorial](options)
    graph.wait_for(show.started, 'the robot does not begin to move')
    wall_start = time.monotonic()
    if options.view:
        page.announce(graph)
    _watch(show, graph)
    wall_time = time.monotonic() - wall_start
    summary, complaint = show.result()
    print(f'{summary}\ntime            {show.duration:.1f} s simulated, {wall_time:.1f} s real')
    if recording:
        print(f'picture         {os.path.relpath(recording.finish())}')
    if complaint:
        print(f'demo: {complaint}', file=sys.stderr)
    return complaint


def _record():
    """Start a recording; without a place for it the demo goes on."""
    try:
        return Recording(RUNS)
    except OSError as error:
        print(f'demo: no recording: {error}', file=sys.stderr)
        return None


def _watch(show, graph):
    line = Line()
    while show.end is None:
        graph.check()
        line.show(show.progress(), show.now)
        time.sleep(0.1)
    line.finish(show.progress())


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
            print(f'\r\033[K{text}', end='', flush=True)
        elif now >= self._next:
            self._next = now + self.PERIOD
            print(text, flush=True)

    def finish(self, text):
        """Leave the text on the screen."""
        print(f'\r\033[K{text}' if self._live else text, flush=True)
