"""Lockstep: time advances only when every node of the graph has finished its work."""

import contextlib
import time
from collections import Counter, deque
from pathlib import Path

import numpy
import rospy
from odometry_common.connections import NO_ANSWER
from odometry_common.parameters import ParameterError

from sim_turtlebot.lockstep.budgets import STALL_TIMEOUT
from sim_turtlebot.lockstep.graph import GraphProcesses
from sim_turtlebot.lockstep.idle import LONGEST_POLL, IdleWaiter

SLEEPER_CHECK_PERIOD = 2.0  # s of wall time between two checks for nodes that sleep by it
MAX_WATCH_RATE = 2.8  # Hz; a thread that watches something may sleep by wall time
MAX_UNPROMPTED = 2  # messages while all are idle; one may come from the node's start
# A node that sleeps by wall time: wall times between its messages are alike, simulated are not.
# The spreads are shares of the mean.
MIN_INTERVALS, MAX_WALL_SPREAD, MIN_SPREAD = 6, 0.05, 0.2
SLEEPS = 'acts by wall time, as time.sleep() and wait_for_service() do: use rospy.sleep()'
STABLE_TIME = 0.5  # s of wall time without a new or ended node before time begins


class Lockstep:
    """Waits for all nodes on this machine, and names once each that it cannot wait for."""

    def __init__(self, tick, cpu_budget):
        """Start with the master.

        :param tick: of the clock (s of simulated time)
        :param cpu_budget: CPU time (s) that a node may use before it is idle
        :raises ParameterError: if /proc does not show the other processes
        """
        _check_proc()
        self._waiter = IdleWaiter(self._report_busy, self._is_flooded, cpu_budget)
        self._graph = GraphProcesses(self._waiter, rospy.get_name(), self._report)
        self._changed = self._next_sleeper_check = 0.0
        self._sleepers = {}  # time of the last check, and sleeps seen by then, by Thread
        self._tick = tick
        self._unprompted = Counter()  # messages while all were idle, by name
        self._times = {}  # of the last messages (s): wall time and simulated time, by name
        self._known = set()
        self._reported = set()

    def wait(self, only_clock=False):
        """Return when every node is idle, or has exceeded its budget.

        :param only_clock: as for IdleWaiter.wait()
        """
        try:
            self._graph.wait(only_clock)
        except NO_ANSWER as error:
            rospy.logwarn_once('lockstep does not wait for new nodes: '
                               f'the master gave no list of nodes ({error})')
        now = time.monotonic()
        if now > self._next_sleeper_check:
            self._next_sleeper_check = now + SLEEPER_CHECK_PERIOD
            self._report_sleepers(now)

    def forget_reports(self):
        """Name again the nodes that cannot be waited for: others may have their names."""
        self._reported.clear()
        self._unprompted.clear()
        self._times.clear()

    def close(self):
        """Stop waiting."""
        self._waiter.close()

    def is_graph_stable(self, stable_time=STABLE_TIME):
        """Refresh the nodes; return whether all are idle, and none came or went for so long (s).

        Time does not begin for this node and rosout alone.
        """
        self._graph.add_starting()
        self.wait()
        now, known = time.monotonic(), self._graph.names | self._waiter.processes.keys()
        if known != self._known or not self._graph.names - {rospy.get_name()}:
            self._known, self._changed = known, now
        return now - self._changed >= stable_time

    def check_senders(self, arrivals, now, unprompted):
        """Name the nodes that send messages by wall time.

        :param arrivals: when the latest message of each node that has sent one since the last call
            came (monotonic, s), by name
        :param now: simulated time (s)
        :param unprompted: the names of those that sent it while all nodes were idle, and nothing
            had been published since
        """
        awaited = {process.name for process in self._waiter.processes.values()}
        for name in (arrivals.keys() & awaited) - self._reported:
            self._unprompted[name] += name in unprompted
            times = self._times.setdefault(name, deque(maxlen=MIN_INTERVALS + 1))
            times.append((arrivals[name], now))
            if self._unprompted[name] >= MAX_UNPROMPTED or _follow_wall_time(times, self._tick):
                self._report(name, SLEEPS)

    def _report_sleepers(self, now):
        """Name the nodes that publish and, since the last call, slept by wall time repeatedly."""
        before, self._sleepers = self._sleepers, {}
        for process in self._waiter.processes.values():
            # roscpp sleeps by wall time wherever it waits.
            if process.is_cpp or process.name not in self._graph.publishers - {rospy.get_name()}:
                continue
            for thread in process.threads.values():
                with contextlib.suppress(OSError):  # it has ended
                    if thread.sleeps_by_wall_time and thread.sleeps_longer_than(
                            process.longest_poll, now):
                        self._sleepers[thread] = now, thread.sleeps_seen
                if thread in before and thread in self._sleepers:
                    earlier, seen_then = before[thread]
                    if thread.sleeps_seen - seen_then > MAX_WATCH_RATE * (now - earlier):
                        self._report(process.name, SLEEPS)

    def _is_flooded(self, process):
        return self._graph.sends_to(self._reported, process.name)

    def _report_busy(self, process, budget):
        if process.is_stopped():
            self._report(process.name, 'has been stopped by a signal or a debugger '
                         f'(process {process.pid}): continue it, or end it')
            return
        if budget is None:
            self._report(process.name, f'has not come to rest for {STALL_TIMEOUT:g} s (process '
                         f'{process.pid}): it hangs, or this machine is too busy')
            return
        self._report(process.name, f'has been busy for {budget:g} s (process {process.pid}): let '
                     'its loop sleep by rospy.Rate or ros::Rate, or raise ~cpu_budget if it '
                     'computes for longer')

    def _report(self, name, reason):
        if name not in self._reported:
            self._reported.add(name)
            rospy.logwarn(f'lockstep does not wait for {name}, so two runs may differ: it {reason}')


def _follow_wall_time(times, tick):
    """Return whether pairs of wall and simulated time (s) are equally far apart by wall time only.

    Simulated times may differ by a tick (s). IdleWaiter waits for sleeps of up to LONGEST_POLL.
    """
    if len(times) <= MIN_INTERVALS or times[-1][0] - times[-2][0] <= LONGEST_POLL:
        return False
    wall, simulated = numpy.diff(times, axis=0).T
    return (numpy.ptp(wall) < MAX_WALL_SPREAD * wall.mean()
            and numpy.ptp(simulated) - 1.01 * tick > MIN_SPREAD * simulated.mean())


def _check_proc():
    """Raise ParameterError unless /proc shows every process, and how often each thread has run."""
    try:
        Path('/proc/1/stat').read_bytes()
        if Path('/proc/self/schedstat').read_text(encoding='utf-8').split()[-1] == '0':
            raise OSError('this kernel lacks CONFIG_SCHED_INFO')
    except OSError as error:
        reason = f'false where /proc hides the state of other processes ({error})'
        raise ParameterError('~lockstep', True, reason) from None
