"""Find the processes of a graph's nodes."""

import time

import psutil
import rosgraph
from odometry_common.connections import ANSWER, ANSWER_TIMEOUT, SENDS, ask, node_at
from rospy.core import is_shutdown_requested

from sim_turtlebot.lockstep.children import Children
from sim_turtlebot.lockstep.idle import LONGEST_POLL
from sim_turtlebot.lockstep.links import is_refused, repeat_update
from sim_turtlebot.lockstep.listeners import pids_at, roslaunched

CONNECT_TIMEOUT = 5.0  # s of wall time, for a connection while all nodes are idle
UNSEEN = ('runs on another machine, in another container or as another user, where lockstep cannot '
          'see it: run it beside the robot')
MASTER = 'the master'
LOG = '/rosout'  # a node, and its topic; it only logs other nodes' messages
VIEWER = 'rviz'  # a program that only shows; without a graphics card it draws without a pause
STARTING_CPU_BUDGET = 30.0  # s of CPU time until a process is a node; on an emulated processor 6


class GraphProcesses:
    """Adds the master, and all nodes that it knows, to an IdleWaiter."""

    def __init__(self, waiter, own_name, report):
        """Add the master.

        :param waiter: sim_turtlebot.lockstep.idle.IdleWaiter
        :param own_name: of this node
        :param report: called with the name of a node that is not awaited, and what is wrong with it
        """
        self._waiter, self._own_name, self._report = waiter, own_name, report
        self._unconnected = set()  # links that are not awaited any more
        self._silent = set()  # names of nodes that do not answer
        self._master_uri = rosgraph.get_master_uri()
        self._master = node_at(self._master_uri)
        self._addresses, self._pids = {}, {}  # by name
        # Names of nodes by topic or service, as the master had them at the last call.
        self._published = self._subscribed = self._served = {}
        self._children = Children(waiter, self._add)
        self._master_usage = None  # of its threads, at the last call
        self._find({MASTER: self._master_uri})

    @property
    def names(self):
        """The names of all nodes."""
        return _names(self._published, self._subscribed, self._served)

    @property
    def publishers(self):
        """The names of the nodes that publish more than their log."""
        return _names(self._published)

    def wait(self, only_clock=False):
        """Return when all nodes are idle.

        If the master served a request, refresh the node list, wait for its publisherUpdates, for
        which it polls by wall time, and wait until all nodes are connected.

        :param only_clock: as for IdleWaiter.wait()
        :raises OSError: if the master does not answer
        """
        self._waiter.wait(only_clock)
        self._children.await_new(self._pids.values())
        if self._master_has_worked():
            try:
                self._await_connections()
            finally:  # also if the master does not answer
                self._waiter.wait()
            self._master_has_worked()  # for the next call: what it has done is awaited

    def sends_to(self, names, name):
        """Return whether one of these nodes publishes a topic to which node `name` subscribes."""
        return any(name in self._subscribed.get(topic, ()) and not names.isdisjoint(publishers)
                   for topic, publishers in self._published.items())

    def _master_has_worked(self):
        """Return whether the master has computed since the last call, or cannot be seen."""
        master = self._waiter.processes.get(self._pids[MASTER])
        if master in self._waiter.stopped:
            return False
        before, self._master_usage = self._master_usage, self._waiter.idle_usage.get(master)
        return self._master_usage != before or master is None

    def _await_connections(self):
        """Return once the list of nodes is stable, and each subscriber is connected or reported."""
        rested = 0.0  # s, while all nodes were idle; a busy machine may need minutes for them
        told = set()  # links of which the subscriber was told again
        while not is_shutdown_requested():
            is_new = self._refresh()
            if is_new:
                self._waiter.wait_for_polls(self._pids[MASTER])
                rested = 0.0
            if not (is_new or self._missing_links()):
                return
            self._waiter.wait()
            missing = self._missing_links()
            refused = {(topic, *names) for topic, *names in missing
                       if is_refused(topic, *map(self._addresses.get, names))}
            self._unconnected |= refused
            if missing := missing - refused:
                time.sleep(LONGEST_POLL)
                rested += LONGEST_POLL
            if rested > CONNECT_TIMEOUT / 2:
                for topic, _, subscriber in missing - told:
                    publishers = self._published.get(topic, ())
                    repeat_update(topic, *(
                        self._addresses.get(name) for name in (subscriber, *publishers)))
                told |= missing
            if rested > CONNECT_TIMEOUT:
                self._unconnected |= missing
                for topic, publisher, subscriber in sorted(missing):
                    self._report(subscriber, f'has not connected to {publisher} on {topic} '
                                 f'for {CONNECT_TIMEOUT:g} s')

    def _missing_links(self):
        """Return topic, publisher and subscriber of each connection that the nodes still make."""
        awaited = {name for name in self._addresses.keys() - self._silent if
                   self._waiter.processes.get(self._pids.get(name)) in self._waiter.awaited}
        wanted = {(topic, publisher, subscriber) for topic, names in self._published.items()
                  if topic != LOG for publisher in awaited.intersection(names)
                  for subscriber in awaited.intersection(self._subscribed.get(topic, ()))}
        wanted -= self._unconnected
        # A subscriber lists a connection early.
        present = {(topic, publisher, subscriber) for publisher in {link[1] for link in wanted}
                   for _, subscriber, direction, _, topic, *_ in self._connections_of(publisher)
                   if direction == SENDS}
        return {link for link in wanted - present if self._silent.isdisjoint(link[1:])}

    def _connections_of(self, name):
        """Return the connections that a node reports; name one that sleeps and answers nothing."""
        # A server of another node may have the address of one that was killed.
        begin = time.monotonic()
        process = self._waiter.processes[self._pids[name]]
        answer = ask(self._addresses[name], 'getBusInfo')
        if answer is None and time.monotonic() - begin > ANSWER_TIMEOUT and process.is_asleep():
            self._silent.add(name)
            self._report(name, f'has not answered for {ANSWER_TIMEOUT:g} s')
        return answer or ()

    def _refresh(self):
        """Add new nodes, forget those that have gone; return whether the publishers have changed.

        A node that was killed and started again has the same name and topics at another address.
        """
        before, addresses_before = self._published, {**self._addresses}
        self._published, self._subscribed, self._served = map(
            dict, self._master.getSystemState(self._own_name)[ANSWER])
        for name in self._addresses.keys() - self.names:
            del self._addresses[name]
        addresses = {name: self._master.lookupNode(self._own_name, name)[ANSWER]
                     for name in self.names if name not in self._addresses
                     or self._pids.get(name) not in self._waiter.processes}
        self._find({name: address for name, address in addresses.items()
                    if address and self._addresses.get(name) != address})
        return (self._published, self._addresses) != (before, addresses_before)

    def add_starting(self):
        """Add the processes that roslaunch started and that have not registered as nodes yet."""
        for name, pid in roslaunched(self._master_uri):
            if name != LOG and pid not in self._waiter.processes:
                self._add(name, pid, STARTING_CPU_BUDGET)

    def _find(self, addresses):
        """Add the processes that serve these addresses, by name of their node."""
        if not addresses:
            return
        self._addresses.update(addresses)
        self._silent -= addresses.keys()
        before, pids = None, pids_at(addresses)
        while pids != before:  # a list that changes meanwhile may lack one, or name its child
            before, pids = pids, pids_at(addresses)
        self._pids.update(pids)
        for name, pid in pids.items():
            if pid is None:
                self._report(name, UNSEEN)
            elif process := self._waiter.processes.get(pid):
                process.name, process.cpu_budget = name, self._waiter.cpu_budget
            elif pid:
                self._add(name, pid)

    def _add(self, name, pid, least_budget=0.0):
        try:
            if psutil.Process(pid).name() == VIEWER:
                return
            polls = name not in (MASTER, self._own_name)
            self._waiter.add(name, pid, LONGEST_POLL if polls else 0.0, least_budget)
            self._children.add_of(pid)
        except PermissionError:
            self._report(name, UNSEEN)
        except (FileNotFoundError, ProcessLookupError, psutil.Error):  # it has ended
            pass


def _names(*states):
    """Return the names of nodes in parts of the master's state, except of those that only log."""
    return {name for state in states for topic, nodes in state.items() if topic != LOG
            for name in nodes} - {LOG}
