"""A master and a paused simulator in lockstep that stay, while nodes run one after the other."""

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

from odometry_tools.runs.launch import CHECK_PERIOD, Launch
from odometry_tools.runs.launch_files import SIMULATOR
from odometry_tools.runs.output import RunError
from odometry_tools.runs.recording import Recording
from odometry_tools.runs.starting import Starting, is_answered, join, registered

SERVICES = {'step': Trigger,
            **dict.fromkeys(('pause_physics', 'unpause_physics', 'reset_simulation'), Empty)}
UNAWAITED = re.compile(r'lockstep does not wait for (/\S+), .*?: it (.*)')  # of the simulator's log
ROBOT_TOPICS = 'odom', 'base_pose_ground_truth'
SLACK = 1e-6  # s
ARRIVAL, WATCH_TIME = 0.025, 0.5  # s of wall time, after the last step
ACTS = 'acts by wall time: it sends while simulated time stands still'
AGAIN = 'has been started again, at a wall time'
LATE = 'became a node only after simulated time had begun'
END_TIMEOUT = 20.0  # s of wall time; rospy takes a tenth of a second


class Recorded(NamedTuple):
    """A run in lockstep."""

    bag: Path
    ended: set  # names of the nodes that ended before it
    crashes: list  # how some of them ended with an error, a line for each
    required: set  # names of the nodes without which the run is over
    unawaited: dict  # why lockstep did not wait, by name of the node


class Session:
    """A context in which nodes run, each time from the robot's start.

    A process can have only one, since rospy begins only once.
    """

    def __init__(self, page_port=0):
        """Start with __enter__(), and a page at a port, if it is not 0."""
        self._master = Launch('odometry_tools', 'session.launch', {'page_port': page_port},
                              is_private=True)
        self._ending = contextlib.ExitStack()  # of the simulator
        self._parameters = None

    def __enter__(self):
        """Start the master, and become a node; RunError: it does not answer."""
        with contextlib.ExitStack() as stack:
            stack.enter_context(self._master)
            join(self._master, 'session')
            self._stack = stack.pop_all()
        self.master = rosgraph.Master(rospy.get_name())
        return self

    def __exit__(self, *_):
        """End everything."""
        self._ending.close()
        self._stack.close()

    def simulate(self, parameters):
        """Start a paused simulator with these parameters, by name, unless it is there already."""
        if parameters == self._parameters:
            return
        self._ending.close()
        self._parameters = None
        forget([f'/{SIMULATOR}'])
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            yaml.safe_dump(
                {'real_time_factor': 0, 'lockstep': True, **parameters, 'paused': True}, file)
            file.flush()
            self.simulator = self._ending.enter_context(
                Launch('odometry_launch', 'sim.launch', {'params': file.name}, beside=self._master))
            self.simulator.wait_until_started()
        self._services = {name: rospy.ServiceProxy(f'{SIMULATOR}/{name}', kind, persistent=True)
                          for name, kind in SERVICES.items()}
        self.simulator.wait_for(self._is_served, 'the simulator does not answer')
        self._parameters = parameters

    def call(self, service):
        """Have the simulator pause, unpause or reset; beside other work it may miss a call."""
        self.simulator.wait_for(lambda: is_answered(self._services[service]),
                                'the simulator does not answer')

    def unawaited(self, since=0):
        """Return why lockstep does not wait, by node, as the simulator's log says since a line."""
        found = filter(None, map(UNAWAITED.search, self.simulator.lines()[since:]))
        return {match[1]: match[2] for match in found}

    def run(self, nodes, seed, end, folder=None, are_watched=True):
        """Run nodes until a simulated time (s), at full speed; return what was Recorded.

        All that the nodes do up to that time is recorded, and nothing after it. They leave
        no process, no registration and no parameter.

        :param nodes: package, name and arguments of their launch file
        :param folder: for the bag (a Path); None: a new one
        :param are_watched: whether the end of a node is an error
        :raises RunError: if the simulator, or a node that is watched, has ended; or if the
            recording is incomplete
        """
        rospy.set_param(f'{SIMULATOR}/seed', seed)
        self.call('reset_simulation')
        lines_before, nodes_before = len(self.simulator.lines()), registered()
        parameters = self.master.getParam('/')
        recording = Recording(folder)
        with Launch(*nodes, watched=None if are_watched else (), beside=self.simulator) as launch:
            starting, begin = self._start(launch, recording), time.monotonic()
            self._advance(launch, end)
            late = (registered() | recording.heard_since(begin)) & launch.names - starting.nodes
            restless = set() if are_watched else _send_while_time_stands_still(recording)
            _await_ends(launch, starting.nodes)
            statuses, bag = launch.statuses(), recording.close()
            crashes = [launch.end_of(name) for name, status in statuses.items() if status != 0]
        forget(f'/{name}' for name in registered() - nodes_before)
        self.master.setParam('/', parameters)
        if not bag:
            raise RunError('the run is not recorded')
        unawaited = dict.fromkeys(restless - statuses.keys(), ACTS)  # who ends may send a zero
        unawaited.update(dict.fromkeys(late, LATE))
        unawaited.update(dict.fromkeys(launch.respawning & statuses.keys(), AGAIN))
        unawaited.update(self.unawaited(lines_before))
        return Recorded(bag, {*statuses}, crashes, launch.required, unawaited)

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
                answer = self._services['step']()
            except rospy.ServiceException:  # a busy machine, or node; the step still goes on
                self.call('pause_physics')
                now = max(now, rospy.get_time())
                continue
            if not answer.success:
                raise RunError('somebody has called unpause_physics, but the run advances time')
            if float(answer.message) < now - SLACK:
                raise RunError(f'somebody has called reset_simulation after {now:g} s')
            now = float(answer.message)

    def _is_served(self):
        """Return whether the simulator serves what it announces last."""
        self.master.lookupService(f'/{SIMULATOR}/step')
        return True


def forget(names):
    """Have the master forget nodes that were killed."""
    with contextlib.redirect_stdout(None):
        rosnode.cleanup_master_blacklist(rosgraph.Master(rospy.get_name()), sorted(names))


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
