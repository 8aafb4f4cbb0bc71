"""A master and a paused simulator in lockstep that stay, beside which nodes run one after the other."""

import contextlib
import re
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import rosgraph
import rosnode
import rospy
import yaml
from std_srvs.srv import Empty, Trigger

from odometry_tools.runs.following import is_answered, join
from odometry_tools.runs.launch import CHECK_PERIOD, Launch
from odometry_tools.runs.output import RunError
from odometry_tools.runs.recording import Recording
from odometry_tools.runs.starting import Starting, registered

SIMULATOR = 'sim_turtlebot'
UNAWAITED = re.compile(r'lockstep does not wait for (/\S+), .*?: it (.*)')  # of the simulator's log
ROBOT_TOPICS = 'odom', 'base_pose_ground_truth'
SLACK = 1e-6  # s
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


class Session:
    """A context in which nodes of launch files run, each time from the robot's start.

    A process can have only one, since rospy begins only once.
    """

    def __init__(self, robot):
        """Start with __enter__(); `robot` has the simulator's parameters by name, without the seed."""
        self._parameters = {'real_time_factor': 0, 'lockstep': True, 'paused': True, **robot}

    def __enter__(self):
        """Start the master and the simulator; RunError: they do not answer."""
        with contextlib.ExitStack() as stack:
            file = stack.enter_context(tempfile.NamedTemporaryFile('w', suffix='.yaml'))
            yaml.safe_dump(self._parameters, file)
            file.flush()
            self._simulator = stack.enter_context(
                Launch('odometry_launch', 'sim.launch', {'params': file.name}))
            join(self._simulator, 'session')
            self._step = rospy.ServiceProxy(f'{SIMULATOR}/step', Trigger, persistent=True)
            self._pause = rospy.ServiceProxy(f'{SIMULATOR}/pause_physics', Empty, persistent=True)
            self._reset = rospy.ServiceProxy(f'{SIMULATOR}/reset_simulation', Empty, persistent=True)
            self._simulator.wait_for(self._is_served, 'the simulator does not answer')
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *_):
        """End everything."""
        self._stack.close()

    def run(self, nodes, seed, end, folder=None, are_watched=True):
        """Run nodes until a simulated time (s), at full speed; return what was Recorded.

        All that the nodes do up to that time is recorded, and nothing after it. They leave no process,
        no registration and no parameter.

        :param nodes: package, name and arguments of their launch file
        :param folder: for the bag (a Path); None: a new one
        :param are_watched: whether the end of a node is an error
        :raises RunError: if the simulator, or a node that is watched, has ended; or if the recording is
            incomplete
        """
        self._begin(seed)
        lines_before, nodes_before = len(self._simulator.lines()), registered()
        with self._restored_parameters():
            recording = Recording(folder)
            with Launch(*nodes, watched=None if are_watched else (), beside=self._simulator) as launch:
                starting = self._start(launch, recording)
                self._advance(launch, end)
                restless = set() if are_watched else _send_while_time_stands_still(recording)
                _await_ends(launch, starting.nodes)
                statuses, bag = launch.statuses(), recording.close()
                crashes = [launch.end_of(name) for name, status in statuses.items() if status != 0]
            _forget(registered() - nodes_before)
        if not bag:
            raise RunError('the run is not recorded')
        found = filter(None, map(UNAWAITED.search, self._simulator.lines()[lines_before:]))
        unawaited = {name: ACTS for name in restless
                     if name.lstrip('/') not in statuses}  # who ends may send a zero
        unawaited.update({match[1]: match[2] for match in found})
        return Recorded(bag, {*statuses}, crashes, launch.required, unawaited)

    def _begin(self, seed):
        """Put the robot back to its start, as a new simulator with this seed would begin."""
        rospy.set_param(f'{SIMULATOR}/seed', seed)
        # On a busy machine it may not answer in time.
        self._simulator.wait_for(lambda: is_answered(self._reset), 'the simulator does not answer')

    def _start(self, launch, recording):
        """Wait until all nodes have started, and the robot is recorded."""
        launch.wait_until_started()
        starting = Starting(launch)
        launch.wait_for(lambda: starting.is_over() and recording.is_connected(*ROBOT_TOPICS),
                        'the nodes do not answer')
        return starting

    def _advance(self, launch, end):
        """Advance simulated time until `end` (s); each step waits until all nodes are idle."""
        now = -1.0
        while now < end - SLACK:
            launch.check()
            try:
                now = float(self._step().message)
            except rospy.ServiceException:  # a busy machine, or node; the step still goes on
                launch.wait_for(lambda: is_answered(self._pause), 'the simulator does not answer')
                now = rospy.get_time()

    def _is_served(self):
        """Return whether the simulator serves what it announces last."""
        rosgraph.Master(rospy.get_name()).lookupService(f'/{SIMULATOR}/step')
        return True

    @contextlib.contextmanager
    def _restored_parameters(self):
        """Put all parameters back to what they are now, once the nodes have ended."""
        master = rosgraph.Master(rospy.get_name())
        before = master.getParam('/')
        try:
            yield
        finally:
            master.setParam('/', before)


def _forget(names):
    """Have the master forget nodes that were killed."""
    with contextlib.redirect_stdout(None):
        rosnode.cleanup_master_blacklist(rosgraph.Master(rospy.get_name()), [f'/{name}' for name in sorted(names)])


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
