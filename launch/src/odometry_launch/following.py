"""Follow the robot of a demo from its start to its end."""

import math
import sys
import time

import rospy
from odometry_common.rospy_fixes import fix_rospy
from std_srvs.srv import Empty

from odometry_launch.folders import RUNS
from odometry_launch.monitors import MoveMonitor, RotateMonitor
from odometry_launch.output import REWRITE, complain
from odometry_launch.recording import Recording
from odometry_launch.silence import Silence

LOOK_PERIOD = 0.1  # s
MONITORS = {'move': MoveMonitor, 'rotate': RotateMonitor}


def follow(options, launch, page, picture):
    """Follow the robot to its end, print the result, and return a complaint or None.

    :param picture: the Future of the module that draws
    """
    launch.wait_until_read()
    launch.wait_for(_join, 'the demo does not become a node')
    recording = _record()
    monitor = MONITORS[options.tutorial](options)
    launch.wait_for(lambda: _are_connected(monitor, recording), 'the nodes do not answer')
    launch.wait_for(unpause, 'the robot stays paused')
    launch.wait_for(monitor.started, 'the robot does not begin to move')
    wall_start = time.monotonic()
    if page:
        page.announce(launch)
    _watch(monitor, launch, Silence(options.real_time_factor))
    wall_time = time.monotonic() - wall_start
    summary, complaint = monitor.result()
    print(f'{summary}\ntime            {monitor.duration:.1f} s simulated, {wall_time:.1f} s real',
          flush=True)
    bag = recording and recording.close()
    if not page:
        launch.terminate()  # the nodes end while the picture is drawn
    if bag:
        picture.result().leave_picture(bag, monitor.end.to_sec())
    if complaint:
        complain(complaint)
    return complaint


def _join():
    fix_rospy()
    rospy.init_node('demo', anonymous=True, disable_signals=True)
    return True


def _record():
    """Start a recording; if it cannot be written, the demo goes on without."""
    try:
        return Recording(RUNS)
    except OSError as error:
        complain(f'no recording: {error}')
        return None


def _are_connected(monitor, recording):
    return monitor.is_connected() and (recording is None or recording.is_connected('odom', 'cmd_vel'))


def unpause():
    """Start simulated time; return whether the simulator has answered."""
    try:
        rospy.ServiceProxy('sim_turtlebot/unpause_physics', Empty)()
    except rospy.ServiceException:
        return False
    return True


def _watch(monitor, launch, silence):
    """Show the robot's progress until it has arrived."""
    line = Line()
    while monitor.end is None:
        launch.check()
        silence.look(monitor.now)
        line.show(monitor.progress(), monitor.now)
        time.sleep(LOOK_PERIOD)
    line.finish(monitor.progress())


class Line:
    """A line that is rewritten on a terminal; elsewhere a line every two simulated seconds."""

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
