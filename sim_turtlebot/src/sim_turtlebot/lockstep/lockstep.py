"""Lockstep: time advances only when every node of the graph has finished its work."""

import contextlib
import http.client
import time
import xmlrpc.client
from collections import Counter, deque
from pathlib import Path

import rospy
from odometry_common.parameters import ParameterError

from sim_turtlebot.lockstep.graph import GraphProcesses
from sim_turtlebot.lockstep.rest import LONGEST_POLL, PATIENCE, Rest

NAP_PERIOD = 2.0  # s of wall time between two looks for nodes that sleep by it
MOST_WATCHING = 2.8  # Hz; a thread that watches something sleeps by wall time to no harm
MOST_UNASKED = 2  # messages while all rest; one may come of the node's start
# Between messages of a node that sleeps by wall time, wall times are alike, simulated times are not.
LEAST_INTERVALS, WALL_SPREAD, SPREAD = 6, 0.05, 0.2
TINY = 1e-9  # s
SLEEPS = 'acts by wall time, as after time.sleep(): use rospy.sleep()'
MOMENT = 0.5  # s of wall time in which nobody comes or goes before time begins
DIFFER = 'two runs may differ'


class Lockstep:
    """Waits for all nodes on this machine, and names once each that it cannot wait for."""

    def __init__(self, is_over, tick=0.0):
        """Begin with the master.

        :param is_over: function that tells whether to wait no longer
        :param tick: of the clock (s of simulated time)
        :raises ParameterError: if /proc does not show what others do
        """
        _check_proc()
        self._rest = Rest(is_over, self._report_restless, self._is_flooded)
        self._graph = GraphProcesses(self._rest, rospy.get_name(), self._report_unseen)
        self._changed = self._next_naps = 0.0
        self._naps = {}  # of threads in long naps: when, and how often they had napped
        self._tick = tick
        self._unasked = Counter()  # messages while all rested, by name
        self._times = {}  # of the last messages (s): wall time and simulated time, by name
        self._known = set()
        self._reported = set()
        self._master_answers = True

    def wait(self, only_clock=False):
        """Return when every node rests, or has been waited for long enough.

        :param only_clock: as for Rest.wait()
        """
        try:
            self._graph.wait(only_clock)
            self._master_answers = True
        except (OSError, http.client.HTTPException, xmlrpc.client.Error) as error:
            if self._master_answers:
                rospy.logwarn(f'lockstep does not wait for new nodes: the master gave no list of nodes ({error})')
            self._master_answers = False
        if time.monotonic() > self._next_naps:
            self._next_naps = time.monotonic() + NAP_PERIOD
            self._look_for_naps(time.monotonic())

    def close(self):
        """Stop waiting."""
        self._rest.close()

    def has_settled(self):
        """Look for nodes; return whether none has come or gone for a moment, and all rest.

        Time does not begin for this node and rosout alone.
        """
        self._graph.add_starting()
        self.wait()
        now, known = time.monotonic(), self._graph.names | self._rest.processes.keys()
        if known != self._known or not self._graph.names - {rospy.get_name()}:
            self._known, self._changed = known, now
        return now - self._changed > MOMENT

    def notice(self, names, now, unasked):
        """Name the nodes that send messages by wall time.

        :param names: of nodes that have sent something since the last call
        :param now: simulated time (s)
        :param unasked: whether all rested, and nothing has been published since
        """
        for name in names & {process.name for process in self._rest.processes.values()} - self._reported:
            self._unasked[name] += unasked
            times = self._times.setdefault(name, deque(maxlen=LEAST_INTERVALS + 1))
            times.append((time.monotonic(), now))
            if self._unasked[name] >= MOST_UNASKED or _follow_wall_time(times, self._tick):
                self._report(name, SLEEPS)

    def _look_for_naps(self, now):
        """Name the nodes that publish and, since the last call, slept by wall time again and again."""
        before, self._naps = self._naps, {}
        for process in self._rest.processes.values():
            # roscpp sleeps by wall time wherever it waits.
            if process.is_cpp or process.name not in self._graph.publishers - {rospy.get_name()}:
                continue
            for thread in process.threads.values():
                with contextlib.suppress(OSError):  # it has ended
                    if (thread.sleeps_by_wall_time
                            and thread.naps_longer_than(process.longest_poll, thread.runs, now)):
                        self._naps[thread] = now, thread.naps_seen
                if thread in before and thread in self._naps:
                    earlier, naps_then = before[thread]
                    if thread.naps_seen - naps_then > MOST_WATCHING * (now - earlier):
                        self._report(process.name, SLEEPS)

    def _is_flooded(self, process):
        return self._graph.sends_to(self._reported, process.name)

    def _report_restless(self, process):
        if process.is_stopped():
            self._report(process.name, 'has been stopped, by a signal or a debugger '
                         f'(process {process.pid}): let it continue, or end it')
            return
        thread = process.awake_thread()
        self._report(process.name, f'has not rested for {PATIENCE:g} s (process {process.pid}, thread '
                     f'{thread.name if thread else "unknown"}): give its loop a rospy.sleep()')

    def _report_unseen(self, name):
        self._report(name, 'is on another machine, in another container or another user\'s, where '
                     'it cannot be seen: run it beside the robot')

    def _report(self, name, reason):
        if name not in self._reported:
            self._reported.add(name)
            rospy.logwarn(f'lockstep does not wait for {name}, so that {DIFFER}: it {reason}')


def _follow_wall_time(times, tick):
    """Return whether pairs of wall and simulated time (s) are equally far apart by wall time only.

    Simulated times may differ by a tick (s). Rest waits for naps that are as short as LONGEST_POLL.
    """
    if len(times) <= LEAST_INTERVALS:
        return False
    wall, simulated = ([after - before for before, after in zip(column, column[1:])]
                       for column in zip(*times))
    return (min(wall) > LONGEST_POLL and _spread(wall, 0.0) < WALL_SPREAD
            and _spread(simulated, 1.01 * tick) > SPREAD)


def _spread(intervals, slack):
    """Return how much more than `slack` the longest is longer than the shortest, as a share of the mean."""
    return (max(intervals) - min(intervals) - slack) * len(intervals) / max(sum(intervals), TINY)


def _check_proc():
    """Refuse a /proc that does not show every process, and how often each of its threads has run."""
    try:
        Path('/proc/1/stat').read_bytes()
        if Path('/proc/self/schedstat').read_text(encoding='utf-8').split()[-1] == '0':
            raise OSError('this kernel lacks CONFIG_SCHED_INFO')
    except OSError as error:
        raise ParameterError('~lockstep', True, 'false where /proc does not show what others do '
                             f'({error})') from None
