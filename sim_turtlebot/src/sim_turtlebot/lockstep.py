"""Lockstep: time advances only when every node of the graph has finished its work."""

import contextlib
import http.client
import time
import xmlrpc.client
from pathlib import Path

import rospy
from odometry_common.parameters import ParameterError

from sim_turtlebot.graph_processes import GraphProcesses
from sim_turtlebot.rest import PATIENCE, Rest

NAP_PERIOD = 2.0  # s of wall time between two looks for nodes that sleep by it
# Hz; threads that watch something sleep by wall time to no harm, as rospy.spin() does at 2 Hz
LEAST_SPINNING, MOST_WATCHING = 1.2, 2.8
SLEEPS = 'sleeps by wall time, as by time.sleep(): use rospy.sleep()'
MOMENT = 0.5  # s of wall time in which nobody comes or goes before time begins
DIFFER = 'two runs may differ'


class Lockstep:
    """Waits for all nodes on this machine, and names once each that it cannot wait for."""

    def __init__(self, is_over):
        """Begin with the master.

        :param is_over: function that tells whether to wait no longer
        :raises ParameterError: if /proc does not show what others do
        """
        _check_proc()
        self._rest = Rest(is_over, self._report_restless)
        self._graph = GraphProcesses(self._rest, rospy.get_name(), self._report_unseen)
        self._changed = self._next_naps = 0.0
        self._naps = {}  # of threads in long naps: when, and how often they had run and napped
        self._known = set()
        self._reported = set()

    def wait(self):
        """Return when every node rests, or has been waited for long enough."""
        try:
            self._graph.wait()
        except (OSError, http.client.HTTPException, xmlrpc.client.Error) as error:
            rospy.logdebug(f'lockstep: the master does not answer: {error}')
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

    def _look_for_naps(self, now):
        """Name the nodes that publish and, since the last call, slept by wall time."""
        before, self._naps = self._naps, {}
        for process in self._rest.processes.values():
            # roscpp sleeps by wall time wherever it waits.
            if process.is_cpp or process.name not in self._graph.publishers - {rospy.get_name()}:
                continue
            for thread in process.threads.values():
                with contextlib.suppress(OSError):  # it has ended
                    runs = thread.usage[2]
                    if (thread.sleeps_by_wall_time
                            and thread.naps_longer_than(process.longest_poll, runs, now)):
                        self._naps[thread] = now, runs, thread.naps_seen
                if thread in before and thread in self._naps:
                    earlier, runs_then, naps_then = before[thread]
                    naps, runs = thread.naps_seen - naps_then, runs - runs_then
                    is_main = thread.tid == process.pid
                    if (naps > MOST_WATCHING * (now - earlier)
                            or is_main and runs < LEAST_SPINNING * (now - earlier)):
                        self._report(process.name, SLEEPS)

    def _report_restless(self, process):
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


def _check_proc():
    """Refuse a /proc that does not show every process, and how often each of its threads has run."""
    try:
        Path('/proc/1/stat').read_bytes()
        if Path('/proc/self/schedstat').read_text(encoding='utf-8').split()[-1] == '0':
            raise OSError('this kernel lacks CONFIG_SCHED_INFO')
    except OSError as error:
        raise ParameterError('~lockstep', True, 'false where /proc does not show what others do '
                             f'({error})') from None
