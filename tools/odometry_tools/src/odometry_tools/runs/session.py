"""A master and a paused simulator in lockstep, kept while nodes run one after the other."""

import contextlib
import os
import re
import tempfile

import rosgraph
import rosnode
import rospy
import yaml
from std_srvs.srv import Empty, Trigger

from odometry_tools.runs.launch import Launch
from odometry_tools.runs.launch_files import SIMULATOR
from odometry_tools.runs.starting import is_answered, join

SERVICES = {'step': Trigger,
            **dict.fromkeys(('pause_physics', 'unpause_physics', 'reset_simulation'), Empty)}
UNAWAITED = re.compile(r'lockstep does not wait for (/\S+), .*?: it (.*)')  # of the simulator's log


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
        os.environ.setdefault('PYTHONHASHSEED', '0')  # nodes have the members of a set in one order
        with contextlib.ExitStack() as stack:
            stack.enter_context(self._master)
            join(self._master, 'session')
            self._stack = stack.pop_all()
        self.master = rosgraph.Master(rospy.get_name())
        return self

    def __exit__(self, *_):
        """End everything."""
        self._master.terminate()  # while the simulator ends
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
        self.services = {name: rospy.ServiceProxy(f'{SIMULATOR}/{name}', kind, persistent=True)
                         for name, kind in SERVICES.items()}
        # The simulator announces this service last.
        self.simulator.wait_for(lambda: self.master.lookupService(f'/{SIMULATOR}/step'),
                                'the simulator does not answer')
        self._parameters = parameters

    def call(self, service):
        """Call a service of the simulator until it answers; on a busy machine a call may fail."""
        self.simulator.wait_for(lambda: is_answered(self.services[service]),
                                'the simulator does not answer')

    def unawaited(self, since=0):
        """Return why lockstep does not wait for nodes, by name, from the simulator's log.

        :param since: first line to read
        """
        found = filter(None, map(UNAWAITED.search, self.simulator.lines()[since:]))
        return {match[1]: match[2] for match in found}


def forget(names):
    """Have the master forget nodes that were killed."""
    with contextlib.redirect_stdout(None):
        rosnode.cleanup_master_blacklist(rosgraph.Master(rospy.get_name()), sorted(names))
