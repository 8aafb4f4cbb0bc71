"""Record nodes in a Session, at full speed, and tell how their run ended."""

import time

import rospy

from odometry_tools.runs.launch import CHECK_PERIOD, Launch
from odometry_tools.runs.launch_files import SIMULATOR
from odometry_tools.runs.output import RunError
from odometry_tools.runs.recording import ROBOT_TOPICS, Recording
from odometry_tools.runs.session import forget
from odometry_tools.runs.starting import Starting, registered
from odometry_tools.runs.tutorials import ARRIVED, LATE
from odometry_tools.sweep.results import UNTIL

CRASHED, NOT_AWAITED = 'crashed', 'not awaited'
SLACK = 1e-6  # s
ARRIVAL, WATCH_TIME = 0.025, 0.5  # s of wall time, after the last step
END_TIMEOUT = 20.0  # s of wall time; rospy takes a tenth of a second


def record(session, nodes, seed, end, folder=None):
    """Run nodes until a simulated time `end` (s); return the bag's path, how they ended, and why.

    All that the nodes do up to that time is recorded, and nothing after it. They leave
    no process, no registration and no parameter.

    :param nodes: package, name and arguments of their launch file
    :param folder: for the bag (a Path); None: a new one
    :raises RunError: if the simulator has ended, or the recording is incomplete
    """
    rospy.set_param(f'{SIMULATOR}/seed', seed)
    session.call('reset_simulation')
    lines_before, nodes_before = len(session.simulator.lines()), registered()
    parameters = session.master.getParam('/')
    recording = Recording(folder)
    with Launch(*nodes, is_watched=False, beside=session.simulator) as launch:
        launch.wait_until_started()
        starting = Starting(launch)
        launch.wait_for(lambda: starting.is_over() and recording.is_connected(*ROBOT_TOPICS),
                        'the nodes do not answer')
        begin = time.monotonic()
        _advance(session, launch, end)
        late = (registered() | recording.heard_since(begin)) & launch.names - starting.nodes
        restless = _send_while_time_stands_still(recording)
        _await_ends(launch, starting.nodes)
        statuses, bag = launch.statuses(), recording.close()
        crashed = [launch.end_of(name) for name, status in statuses.items() if status != 0]
    forget(f'/{name}' for name in registered() - nodes_before)
    session.master.setParam('/', parameters)
    if not bag:
        raise RunError('the run is not recorded')
    ended = statuses.keys()
    if crashed:
        return bag, CRASHED, '; '.join(crashed)
    unawaited = session.unawaited(lines_before)
    # A node that ends may send a zero.
    if restless - ended or late or launch.respawning & ended or unawaited:
        return bag, NOT_AWAITED, '; '.join(f'{name} {why}' for name, why in unawaited.items())
    if not launch.required:
        return bag, UNTIL, ''
    return bag, ARRIVED if launch.required <= ended else LATE, ''


def _advance(session, launch, end):
    """Advance simulated time until `end` (s); each step waits until all nodes are idle."""
    now = -1.0
    while now < end - SLACK:
        launch.check()
        try:
            answer = session.services['step']()
        except rospy.ServiceException:  # a busy machine, or node; the step still goes on
            session.call('pause_physics')
            now = max(now, rospy.get_time())
            continue
        if not answer.success:
            raise RunError('somebody has called unpause_physics, but the run advances time')
        if float(answer.message) < now - SLACK:
            raise RunError(f'somebody has called reset_simulation after {now:g} s')
        now = float(answer.message)


def _send_while_time_stands_still(recording):
    """Return the names of the nodes that send something after a step, when all nodes are idle.

    In a short run the simulator may not see that they sleep by wall time.
    """
    end = time.monotonic() + ARRIVAL
    time.sleep(WATCH_TIME)
    return recording.heard_since(end)


def _await_ends(launch, nodes):
    """Return once the processes of the nodes that have left the graph have ended, too."""
    end, left = time.monotonic() + END_TIMEOUT, nodes - registered()
    while left - launch.statuses().keys() and time.monotonic() < end:
        time.sleep(CHECK_PERIOD)
