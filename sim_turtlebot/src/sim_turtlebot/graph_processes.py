"""Which processes the nodes of a graph are."""

from urllib.parse import urlparse

import psutil
import rosgraph
from odometry_common.connections import node_at
from rosgraph.network import is_local_address

from sim_turtlebot.rest import ENDED

ANSWER = 2  # where an answer of the master has what it was asked for
MASTER = 'the master'
LOG = '/rosout'  # a node, and its topic; it only writes down what others say
ROSLAUNCHED = '__name:='  # is in the command line of a node that roslaunch has started


class GraphProcesses:
    """Has a sim_turtlebot.rest.Rest wait for the master and for all nodes that it knows."""

    def __init__(self, rest, own_name, on_unseen):
        """Take the master.

        :param own_name: of this node
        :param on_unseen: function of the name of a node whose process cannot be seen
        """
        self._rest, self._own_name, self._on_unseen = rest, own_name, on_unseen
        self._uri = rosgraph.get_master_uri()
        self._master = node_at(self._uri)
        self._pids = {}  # by name; None: the process has ended, or cannot be seen
        self.publishers = set()  # the names of all nodes that publish more than their log
        self._add({MASTER: self._uri})

    @property
    def names(self):
        """The names of all nodes."""
        return self._pids.keys() - {MASTER}

    def refresh(self):
        """Take the nodes that have come, and forget those that have gone; OSError: no master."""
        state = self._master.getSystemState(self._own_name)[ANSWER]
        self.publishers = {name for topic, nodes in state[0] if topic != LOG for name in nodes}
        names = {name for topics in state for _, nodes in topics for name in nodes} - {LOG}
        for name in self.names - names:
            del self._pids[name]
        new = [name for name in names
               if self._pids.get(name, 0) not in (None, *self._rest.processes)]
        if new:
            self._add({name: self._master.lookupNode(self._own_name, name)[ANSWER] for name in new})

    def add_starting(self):
        """Take the processes that roslaunch has started and that are no nodes yet."""
        for process in psutil.process_iter(['cmdline', 'environ']):
            name = next((argument for argument in process.info['cmdline'] or ()
                         if argument.startswith(ROSLAUNCHED)), None)
            if name not in (None, ROSLAUNCHED + 'rosout') and (process.info['environ'] or {}).get('ROS_MASTER_URI') == self._uri:
                self._see(name[len(ROSLAUNCHED):], process.pid)

    def _add(self, uris):
        """Find the processes that serve these URIs, by name."""
        pids = {socket.laddr.port: socket.pid for socket in psutil.net_connections('tcp')
                if socket.status == psutil.CONN_LISTEN}
        for name, uri in uris.items():
            address = urlparse(uri)
            # A port of this machine that nobody serves is that of a node that has ended.
            is_here = is_local_address(address.hostname)
            pid = pids.get(address.port, 0) if is_here else None
            self._pids[name] = pid if pid and self._see(name, pid) else None
            if pid is None:
                self._on_unseen(name)

    def _see(self, name, pid):
        """Wait for a process; return whether it can be seen."""
        if pid not in self._rest.processes:
            try:
                self._rest.add(name, pid, name != MASTER)
            except OSError as error:
                if error.errno not in ENDED:
                    self._on_unseen(name)
                return False
        return True
