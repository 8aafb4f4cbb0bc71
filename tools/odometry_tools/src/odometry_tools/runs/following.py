"""Follow the robot of a demo from its start to its end."""

import contextlib
import queue
import socket
import sys
import threading
import time
from functools import partial

import rospy
from nav_msgs.msg import Odometry
from odometry_common.connections import is_connected
from std_srvs.srv import Empty

from odometry_tools.runs.output import Line, bar, complain
from odometry_tools.runs.recording import Recording, leave_picture
from odometry_tools.runs.starting import is_answered, join
from odometry_tools.runs.tutorials import ARRIVED, HEADING_TOLERANCE, TUTORIALS, follow, motion_in

PROGRESS_PERIOD = 0.1  # s of wall time
LINE_PERIOD = 2.0  # s of simulated time
MAX_DIFFERENCE = 1e-3  # m, and share of the distance; the summed path is not quite straight
SUMMARIES = {'move': 'moved distance  {moved:.3f} m, summed from /odom\n'
                     'true distance   {true_distance:.3f} m, in the simulated world',
             'rotate': 'heading         {heading:.2f} degrees, from /odom\n'
                       'true turn       {true_heading:.2f} degrees, in the simulated world'}


def follow_robot(options, launch, page_port):
    """Follow the robot until it arrives, print the result, and return a complaint or None.

    :param page_port: HeldPort of the page; None without one
    """
    join(launch, 'demo')
    recording, ticks = _record(), Ticks()
    launch.wait_for(lambda: (ticks.are_connected() and (
        not recording or recording.is_connected('odom', 'cmd_vel'))), 'the nodes do not answer')
    launch.wait_for(unpause, 'the robot stays paused')
    launch.wait_for(ticks.have_begun, 'the robot sends no odometry')
    wall_start = time.monotonic()
    if page_port:
        launch.wait_for(lambda: _listens(page_port.number), 'the page does not answer')
        print(f'view            http://localhost:{page_port.number}', flush=True)
    loop, line = TUTORIALS[options.tutorial](vars(options)), Line(LINE_PERIOD)
    metrics = follow(loop, _with_progress(loop, ticks, line, launch), lambda *_: None)
    line.finish(_progress(loop, metrics['time']))
    wall_time = time.monotonic() - wall_start
    print(f'{SUMMARIES[options.tutorial].format(**metrics)}\n'
          f'time            {metrics["time"]:.1f} s simulated, {wall_time:.1f} s real', flush=True)
    bag = recording and recording.close()
    # Meanwhile rospy ends, and without the page the nodes do: each waits for threads of its own.
    threading.Thread(target=rospy.signal_shutdown, args=['the run is over'], daemon=True).start()
    if not page_port:
        launch.terminate()
    if bag:
        leave_picture(bag, metrics['time'], **loop.targets)
    if complaint := complaint_about(options.tutorial, metrics):
        complain(complaint)
    if page_port and sys.stdout.isatty():
        _keep_page(launch)
    return complaint


def complaint_about(tutorial, metrics):
    """Return what is wrong with the metrics of a run, or None."""
    if metrics['ended'] != ARRIVED:
        return f'the robot has not arrived: {metrics["ended"]}'
    if tutorial == 'move':
        difference = abs(metrics['moved'] - metrics['true_distance'])
        differs = difference > MAX_DIFFERENCE * (1 + metrics['moved'])
        return 'the two distances do not agree' if differs else None
    is_off = abs(metrics['true_error']) > HEADING_TOLERANCE + 0.01
    return f'over {HEADING_TOLERANCE} degrees from the target' if is_off else None


class Ticks:
    """Odometry and ground truth of the same moment, whichever arrives first."""

    def __init__(self):
        """Subscribe."""
        self._incomplete = {}  # messages by stamp and topic
        self._complete = queue.Queue()
        self._lock = threading.Lock()
        self._subscribers = [
            rospy.Subscriber(topic, Odometry, partial(self.add, topic), tcp_nodelay=True)
            for topic in ('odom', 'base_pose_ground_truth')]

    def are_connected(self):
        """Return whether the next message of each topic arrives."""
        return all(map(is_connected, self._subscribers))

    def have_begun(self):
        """Return whether there is one."""
        return not self._complete.empty()

    def add(self, topic, message):
        """Take a message."""
        stamp = message.header.stamp.to_nsec()
        with self._lock:
            tick = self._incomplete.setdefault(stamp, {})
            tick[topic] = motion_in(message)
            if len(tick) == 2:
                del self._incomplete[stamp]
                self._complete.put((message.header.stamp.to_sec(), tick['odom'],
                                    tick['base_pose_ground_truth']))

    def next(self, timeout):
        """Return stamp (s), odometry and ground truth; raise queue.Empty after a time (s)."""
        return self._complete.get(timeout=timeout)


def _with_progress(loop, ticks, line, launch):
    """Yield each tick, and show how far a loop is after it."""
    shown = 0.0
    while True:
        launch.check()
        try:
            tick = ticks.next(PROGRESS_PERIOD)
        except queue.Empty:
            continue
        yield tick
        if time.monotonic() - shown > PROGRESS_PERIOD:
            shown = time.monotonic()
            line.show(_progress(loop, tick[0]), tick[0])


def _progress(loop, time):
    share, state = loop.progress()
    return f'{bar(share)} {state}, {time:.1f} s'


def _record():
    """Start a recording; without a writable folder the demo continues without it."""
    try:
        return Recording()
    except OSError as error:
        complain(f'no recording: {error}')
        return None


def unpause():
    """Start simulated time; return whether the simulator answers."""
    return is_answered(rospy.ServiceProxy('sim_turtlebot/unpause_physics', Empty))


def _listens(port):
    with socket.socket() as connection:
        return connection.connect_ex(('localhost', port)) == 0


def _keep_page(launch):
    """Keep the page open until Ctrl-C, which is then no failure."""
    print('The page stays, and its pad drives the robot, until Ctrl-C.', flush=True)
    with contextlib.suppress(KeyboardInterrupt):
        while True:
            launch.check()
            time.sleep(PROGRESS_PERIOD)
