"""Which processes the nodes of a graph are."""

import contextlib
import os
from pathlib import Path

import psutil
import rosgraph
from odometry_common.connections import node_at
from rosgraph.names import ns_join

from sim_turtlebot.lockstep.listeners import pids_at
from sim_turtlebot.lockstep.rest import LONGEST_POLL, PATIENCE

PUBLISHERS = 0  # where the master's state has them
MOST_GENERATIONS = 10  # of children, in one wait: others on this machine may start some all the time
ANSWER = 2  # where an answer of the master has what it was asked for
MASTER = 'the master'
LOG = '/rosout'  # a node, and its topic; it only writes down what others say
ROSLAUNCHED = '__name:='  # is in the command line of a node that roslaunch has started
CHILD_PATIENCE = 10.0  # s of CPU time until a child rests; it may be a node that starts
STARTING_PATIENCE = 30.0  # s of CPU time until a process is a node; on an emulated processor 6


class GraphProcesses:
    """Has a sim_turtlebot.lockstep.rest.Rest wait for the master and for all nodes that it knows."""

    def __init__(self, rest, own_name, on_unseen):
        """Take the master.

        :param own_name: of this node
        :param on_unseen: function of the name of a node whose process cannot be seen
        """
        self._rest, self._own_name, self._on_unseen = rest, own_name, on_unseen
        self._master_uri = rosgraph.get_master_uri()
        self._master = node_at(self._master_uri)
        self._addresses, self._pids = {}, {}  # by name
        self._state = [], [], []  # what the master said last: publishers, subscribers, services
        self._newest = _newest_pid()
        self._children = {}  # id of the parent, by id
        self._usage = None  # of the master's threads, when it was asked last
        self._find({MASTER: self._master_uri})

    @property
    def names(self):
        """The names of all nodes."""
        return _names(*self._state)

    @property
    def publishers(self):
        """The names of those that publish more than their log."""
        return _names(self._state[PUBLISHERS])

    def wait(self, only_clock=False):
        """Return when all rest; OSError: no master.

        If the master was asked for something, wait for new nodes, and until it has told everybody of
        new publishers: it looks for such work by wall time.

        :param only_clock: as for Rest.wait()
        """
        self._rest.wait(only_clock)
        self._await_children()
        if self._was_asked():
            try:
                while self._refresh():
                    self._rest.wait_for_naps(self._pids[MASTER])
            finally:  # also if the master does not answer
                self._rest.wait()
            self._was_asked()

    def sends_to(self, names, name):
        """Return whether one of these nodes publishes a topic to which the one called `name` subscribes."""
        published, subscribed, _ = map(dict, self._state)
        return any(name in subscribed.get(topic, ()) and not names.isdisjoint(publishers)
                   for topic, publishers in published.items())

    def _await_children(self):
        """Take the processes that nodes have started to work for them, and wait until they rest, too."""
        for _ in range(MOST_GENERATIONS):
            before, self._newest = self._newest, _newest_pid()
            if self._newest == before:
                return
            self._forget_independent()
            for pid in filter(psutil.pid_exists, range(before + 1, self._newest + 1)):
                with contextlib.suppress(psutil.NoSuchProcess):
                    self._add_child(self._rest.processes.get(psutil.Process(pid).ppid()), pid)
            self._rest.wait()

    def _was_asked(self):
        """Return whether the master has computed since the last call, or cannot be seen."""
        master = self._rest.processes.get(self._pids[MASTER])
        if master in self._rest.stopped:
            return False
        before, self._usage = self._usage, self._rest.rested.get(master)
        return self._usage != before or master is None

    def _refresh(self):
        """Take the nodes that have come, and forget those that have gone; return whether any publishes.

        One that was killed and started again has the same name and topics at another address.
        """
        before, addresses_before = self._state[PUBLISHERS], {**self._addresses}
        self._state = self._master.getSystemState(self._own_name)[ANSWER]
        for name in self._addresses.keys() - self.names:
            del self._addresses[name]
        addresses = {name: self._master.lookupNode(self._own_name, name)[ANSWER]
                     for name in self.names if self._pids.get(name) not in self._rest.processes}
        self._find({name: address for name, address in addresses.items()
                    if address and self._addresses.get(name) != address})
        return (self._state[PUBLISHERS], self._addresses) != (before, addresses_before)

    def add_starting(self):
        """Take the processes that roslaunch has started and that are no nodes yet."""
        for process in psutil.process_iter(['cmdline', 'environ']):
            environment = process.info['environ'] or {}
            name = next((ns_join(environment.get('ROS_NAMESPACE', '/'), argument[len(ROSLAUNCHED):])
                         for argument in process.info['cmdline'] or ()
                         if argument.startswith(ROSLAUNCHED)), LOG)
            if (name != LOG and process.pid not in self._rest.processes
                    and environment.get('ROS_MASTER_URI') == self._master_uri):
                self._add(name, process.pid, STARTING_PATIENCE)

    def _find(self, addresses):
        """Find the processes that serve these addresses, by name of their node."""
        if not addresses:
            return
        self._addresses.update(addresses)
        before, pids = None, pids_at(addresses)
        while pids != before:  # a list that others change meanwhile may lack one, or name its child
            before, pids = pids, pids_at(addresses)
        self._pids.update(pids)
        for name, pid in pids.items():
            if pid is None:
                self._on_unseen(name)
            elif pid in self._rest.processes:
                self._rest.processes[pid].name, self._rest.processes[pid].patience = name, PATIENCE
            elif pid:
                self._add(name, pid, PATIENCE)

    def _add(self, name, pid, patience):
        try:
            computes = name in (MASTER, self._own_name)
            self._rest.add(name, pid, 0.0 if computes else LONGEST_POLL, patience)
            for child in psutil.Process(pid).children():
                self._add_child(self._rest.processes[pid], child.pid)
        except PermissionError:
            self._on_unseen(name)
        except (FileNotFoundError, ProcessLookupError, psutil.Error):  # it has ended
            pass


    def _add_child(self, parent, pid):
        """Take a process that works for a node: not one that has been given a process group of its own."""
        if (parent and parent.longest_poll and pid not in self._rest.processes
                and _are_one_group(pid, parent.pid)):
            self._children[pid] = parent.pid
            self._add(parent.name, pid, CHILD_PATIENCE)

    def _forget_independent(self):
        """Forget the children that have ended, or have been given a group of their own since."""
        for pid, parent in list(self._children.items()):
            if not _are_one_group(pid, parent):
                del self._children[pid]
                if pid in self._rest.processes and pid not in self._pids.values():
                    self._rest.remove(pid)


def _are_one_group(*pids):
    try:
        return len({os.getpgid(pid) for pid in pids}) == 1
    except ProcessLookupError:
        return False


def _newest_pid():
    """Return the id of the process or thread that has begun last on this machine."""
    return int(Path('/proc/loadavg').read_text(encoding='ascii').split()[-1])


def _names(*states):
    """Return the names of the nodes in parts of the master's state, but for rosout and what all log."""
    return {name for state in states for topic, nodes in state if topic != LOG
            for name in nodes} - {LOG}
