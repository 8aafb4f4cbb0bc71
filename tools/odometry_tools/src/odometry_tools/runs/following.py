"""Follow the robot of a demo from its start to its end."""

import contextlib
import socket
import sys
import threading
import time

import rospy
from odometry_common.rospy_fixes import fix_rospy
from std_srvs.srv import Empty

from odometry_tools.runs.monitors import MoveMonitor, RotateMonitor
from odometry_tools.runs.output import Line, complain
from odometry_tools.runs.recording import Recording, leave_picture

PROGRESS_PERIOD = 0.1  # s of wall time
LINE_PERIOD = 2.0  # s of simulated time
MONITORS = {'move': MoveMonitor, 'rotate': RotateMonitor}


def follow(options, launch, page_port):
    """Follow the robot until it arrives, print the result, and return a complaint or None.

    :param page_port: HeldPort of the page; None without one
    """
    join(launch, 'demo')
    recording = _record()
    monitor = MONITORS[options.tutorial](options)
    launch.wait_for(lambda: (monitor.is_connected() and (
        not recording or recording.is_connected('odom', 'cmd_vel'))), 'the nodes do not answer')
    launch.wait_for(unpause, 'the robot stays paused')
    launch.wait_for(monitor.started, 'the robot does not begin to move')
    wall_start = time.monotonic()
    if page_port:
        launch.wait_for(lambda: _listens(page_port.number), 'the page does not answer')
        print(f'view            http://localhost:{page_port.number}', flush=True)
    _watch(monitor, launch)
    wall_time = time.monotonic() - wall_start
    summary, complaint = monitor.result()
    print(f'{summary}\ntime            {monitor.now:.1f} s simulated, {wall_time:.1f} s real',
          flush=True)
    bag = recording and recording.close()
    # Meanwhile rospy ends, and without the page the nodes do: each waits for threads of its own.
    threading.Thread(target=rospy.signal_shutdown, args=['the run is over'], daemon=True).start()
    if not page_port:
        launch.terminate()
    if bag:
        targets = ({'distance_target': options.distance} if options.tutorial == 'move'
                   else {'heading_target': options.target})
        leave_picture(bag, monitor.end.to_sec(), **targets)
    if complaint:
        complain(complaint)
    if page_port and sys.stdout.isatty():
        _keep_page(launch)
    return complaint


def join(launch, name):
    """Make this process a node of a Launch."""
    def start():
        fix_rospy()
        rospy.init_node(name, anonymous=True, disable_signals=True)
        return True

    launch.wait_until_started()
    launch.wait_for(start, f'the {name} does not become a node')


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


def is_answered(call):
    """Call a service without arguments, by its ServiceProxy; return whether it answers in time."""
    try:
        call()
    except rospy.ServiceException:
        return False
    return True


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


def _watch(monitor, launch):
    """Show the robot's progress until it arrives."""
    line = Line(LINE_PERIOD)
    while monitor.end is None:
        launch.check()
        line.show(monitor.progress(), monitor.now)
        time.sleep(PROGRESS_PERIOD)
    line.finish(monitor.progress())
