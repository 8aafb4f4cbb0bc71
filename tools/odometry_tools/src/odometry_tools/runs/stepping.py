"""Run the nodes of a launch file beside a robot in lockstep, and record them."""

import re
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import psutil
import rosgraph
import rospy
import yaml
from std_srvs.srv import Trigger

from odometry_tools.runs.following import is_answered, join
from odometry_tools.runs.launch import CHECK_PERIOD, Launch
from odometry_tools.runs.output import RunError
from odometry_tools.runs.recording import Recording

SIMULATOR = 'sim_turtlebot'
STEP, PAUSE = f'{SIMULATOR}/step', f'{SIMULATOR}/pause_physics'  # which is served after a step
OURS = SIMULATOR, 'master'
UNAWAITED = re.compile(r'lockstep does not wait for (/\S+), .*?: it (.*)')  # of the simulator's log
ROBOT_TOPICS = 'odom', 'base_pose_ground_truth'
SLACK = 1e-6  # s
HELPER_TIME = 1.0  # s of wall time
ARRIVAL, WATCH_TIME = 0.025, 0.5  # s of wall time, after the last step
ACTS = 'acts by wall time: it sends while simulated time stands still'
END_TIMEOUT = 20.0  # s of wall time; rospy takes a tenth of a second


class Recorded(NamedTuple):
    """A run in lockstep."""

    bag: Path
    ended: set  # names of the nodes that ended before it
    crashes: list  # how some of them ended with an error, a line for each
    required: set  # names of the nodes without which the run is over
    unawaited: dict  # why lockstep did not wait, by name of the node


def record(nodes, robot, end, folder=None, are_watched=True):
    """Run nodes until a simulated time (s), at full speed; return what was Recorded.

    All that the nodes do up to that time is recorded, and nothing after it.

    :param nodes: package, name and arguments of their launch file
    :param robot: the simulator's parameters by name
    :param folder: for the bag (a Path); None: a new one
    :param are_watched: whether the end of a node is an error
    :raises RunError: if the simulator, or a node that is watched, has ended
    """
    with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
        yaml.safe_dump({'real_time_factor': 0, 'lockstep': True, 'paused': True, **robot}, file)
        file.flush()
        with Launch('sim.launch', {'params': file.name}, beside=nodes,
                    watched=None if are_watched else OURS) as launch:
            join(launch, 'record')
            recording, starting = Recording(folder), Starting(launch)
            launch.wait_for(lambda: starting.is_over() and _is_ready(recording), 'the nodes do not answer')
            _step(launch, end)
            restless = set() if are_watched else _send_while_time_stands_still(recording)
            _await_ends(launch, starting.nodes)
            bag, statuses, required = recording.close(), launch.statuses(), launch.required - {SIMULATOR}
            crashes = [launch.end_of(name) for name, status in statuses.items() if status != 0]
            restless = {name for name in restless if name.lstrip('/') not in statuses}  # who ends may send a zero
            found = filter(None, map(UNAWAITED.search, launch.lines()))
    if not bag:
        raise RunError('the run is not recorded')
    return Recorded(bag, {*statuses}, crashes, required,
                    {**dict.fromkeys(restless, ACTS), **{match[1]: match[2] for match in found}})


class Starting:
    """Tells whether the processes of a launch file have become nodes, have ended, or are no nodes."""

    def __init__(self, launch):
        self.nodes = set()  # names of those that are known to the master
        self._launch = launch
        self._asleep = {}  # by name: their CPU times and states, and since when (s) these are the same

    def is_over(self):
        """Check once more; to be called again and again."""
        self.nodes |= _registered() & self._launch.names
        waiting = [(name, pid) for name, pid in self._launch.pids().items() if name not in self.nodes]
        return all(self._has_slept(name, pid) for name, pid in waiting)

    def _has_slept(self, name, pid):
        """Return whether a process and its children have slept for HELPER_TIME: a node would compute."""
        try:
            process = psutil.Process(pid)
            state = [(one.cpu_times(), one.status()) for one in (process, *process.children(recursive=True))]
        except (psutil.NoSuchProcess, ValueError):  # roslaunch will notice, or has not started it yet
            return False
        now = time.monotonic()
        before, since = self._asleep.get(name, (None, now))
        if state != before or any(status != psutil.STATUS_SLEEPING for _, status in state):
            since = now
        self._asleep[name] = state, since
        return now - since > HELPER_TIME


def _registered():
    """Return the names of all nodes that the master knows."""
    state = rosgraph.Master(rospy.get_name()).getSystemState()
    return {name.lstrip('/') for kind in state for _, names in kind for name in names}


def _is_ready(recording):
    """Return whether the robot answers, and is recorded."""
    rosgraph.Master(rospy.get_name()).lookupService(f'/{STEP}')
    return recording.is_connected(*ROBOT_TOPICS)


def _send_while_time_stands_still(recording):
    """Return the names of the nodes that send something after a step, when all nodes are idle.

    In a short run the simulator may not see that they sleep by wall time.
    """
    end = time.monotonic() + ARRIVAL
    time.sleep(WATCH_TIME)
    return recording.heard_since(end)


def _await_ends(launch, nodes):
    """Return once the processes of the nodes that have left the graph have ended, too."""
    end, left = time.monotonic() + END_TIMEOUT, nodes - _registered()
    while left - launch.statuses().keys() and time.monotonic() < end:
        time.sleep(CHECK_PERIOD)


def _step(launch, end):
    """Advance simulated time until `end` (s); each step waits until all nodes are idle."""
    step, now = rospy.ServiceProxy(STEP, Trigger, persistent=True), -1.0
    while now < end - SLACK:
        launch.check()
        try:
            now = float(step().message)
        except rospy.ServiceException:  # a busy machine, or node; the step still goes on
            launch.wait_for(lambda: is_answered(PAUSE), 'the simulator does not answer')
            now = rospy.get_time()
