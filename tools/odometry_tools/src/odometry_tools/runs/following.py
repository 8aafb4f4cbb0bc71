"""Follow the robot of a demo from its start to its end."""

import contextlib
import queue
import sys
import threading
import time

import message_filters
import rospy
from nav_msgs.msg import Odometry
from std_srvs.srv import Empty

from odometry_tools.runs.output import Line, bar, complain
from odometry_tools.runs.ports import listens
from odometry_tools.runs.recording import ROBOT_TOPICS, Recording, leave_picture
from odometry_tools.runs.starting import is_answered, join
from odometry_tools.runs.tutorials import ARRIVED, TUTORIALS, follow, motion_in

PROGRESS_PERIOD = 0.1  # s of wall time
LINE_PERIOD = 2.0  # s of simulated time
MOST_APART = 1000  # messages of one topic before that of the other
SUMMARIES = {'move': 'moved distance  {moved:.3f} m, summed from /odom\n'
                     'true distance   {true_distance:.3f} m, in the simulated world',
             'rotate': 'heading         {heading:.2f} degrees, from /odom\n'
                       'true turn       {true_heading:.2f} degrees, in the simulated world'}


def follow_robot(options, launch, page_port):
    """Follow the robot until it stops; print the result, and return whether it has arrived.

    :param page_port: HeldPort of the page; None without one
    """
    join(launch, 'demo')
    recording = Recording()
    try:
        return _follow(options, launch, page_port, recording)
    finally:
        recording.close_bag()  # also of a run that is interrupted


def _follow(options, launch, page_port, recording):
    ticks = _subscribe()
    launch.wait_for(lambda: recording.is_connected(*ROBOT_TOPICS, 'cmd_vel'),
                    'the nodes do not answer')
    unpause = rospy.ServiceProxy('sim_turtlebot/unpause_physics', Empty)
    launch.wait_for(lambda: is_answered(unpause), 'the robot stays paused')
    launch.wait_for(lambda: not ticks.empty(), 'the robot sends no odometry')
    wall_start = time.monotonic()
    if page_port:
        launch.wait_for(lambda: listens(page_port.number), 'the page does not answer')
        print(f'view            http://localhost:{page_port.number}', flush=True)
    loop, line = TUTORIALS[options.tutorial](vars(options)), Line(LINE_PERIOD)
    metrics = follow(loop, _with_progress(loop, ticks, line, launch), lambda *_: None)
    line.finish(_progress(loop, metrics['time']))
    wall_time = time.monotonic() - wall_start
    print(f'{SUMMARIES[options.tutorial].format(**metrics)}\n'
          f'time            {metrics["time"]:.1f} s simulated, {wall_time:.1f} s real', flush=True)
    bag = recording.close()
    # Meanwhile rospy ends, and without the page the nodes do: each waits for threads of its own.
    threading.Thread(target=rospy.signal_shutdown, args=['the run is over'], daemon=True).start()
    if not page_port:
        launch.terminate()
    if bag:
        leave_picture(bag, metrics['time'], **loop.targets)
    has_arrived = metrics['ended'] == ARRIVED
    if not has_arrived:
        complain(f'the robot has not arrived: {metrics["ended"]}')
    if page_port and sys.stdout.isatty():
        _keep_page(launch)
    return has_arrived


def _subscribe():
    """Return a queue of stamp (s), odometry and ground truth of each moment."""
    ticks = queue.Queue()
    subscribers = [message_filters.Subscriber(topic, Odometry, tcp_nodelay=True)
                   for topic in ROBOT_TOPICS]
    message_filters.TimeSynchronizer(subscribers, MOST_APART).registerCallback(
        lambda *messages: ticks.put((messages[0].header.stamp.to_sec(),
                                     *map(motion_in, messages))))
    return ticks


def _with_progress(loop, ticks, line, launch):
    """Yield each tick, and show how far a loop is after it."""
    shown = 0.0
    while True:
        launch.check()
        try:
            tick = ticks.get(timeout=PROGRESS_PERIOD)
        except queue.Empty:
            continue
        yield tick
        if time.monotonic() - shown > PROGRESS_PERIOD:
            shown = time.monotonic()
            line.show(_progress(loop, tick[0]), tick[0])


def _progress(loop, time):
    share, state = loop.progress()
    return f'{bar(share)} {state}, {time:.1f} s'


def _keep_page(launch):
    """Keep the page open until Ctrl-C, which is then no failure."""
    print('The page stays, and its pad drives the robot, until Ctrl-C.', flush=True)
    with contextlib.suppress(KeyboardInterrupt):
        while True:
            launch.check()
            time.sleep(PROGRESS_PERIOD)
