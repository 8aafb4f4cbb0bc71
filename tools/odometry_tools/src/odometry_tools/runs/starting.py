"""Become a node of a launch file's master, and wait until its processes are nodes, too."""

import time

import psutil
import rosgraph
import rospy
from odometry_common.rospy_fixes import fix_rospy

HELPER_TIME = 1.0  # s of wall time


def join(launch, name):
    """Make this process a node of a Launch."""
    def start():
        fix_rospy()
        rospy.init_node(name, anonymous=True, disable_signals=True)
        return True

    launch.wait_until_started()
    launch.wait_for(start, f'the {name} does not become a node')


def is_answered(call):
    """Call a service without arguments, by its ServiceProxy; return whether it answers in time."""
    try:
        call()
    except rospy.ServiceException:
        return False
    return True


class Starting:
    """Notices when each process of a launch file is a node, has exited, or sleeps, as no node."""

    def __init__(self, launch):
        self.nodes = set()  # names of those that are known to the master
        self._launch = launch
        self._asleep = {}  # by name: CPU times and states, and since when (s) these are the same

    def is_over(self):
        """Return whether all have; call it repeatedly."""
        self.nodes |= registered() & self._launch.names
        waiting = [(name, pid) for name, pid in self._launch.pids().items()
                   if name not in self.nodes]
        return all(self._has_slept(name, pid) for name, pid in waiting)

    def _has_slept(self, name, pid):
        """Return whether a process and its children slept for HELPER_TIME: a node would compute."""
        try:
            process = psutil.Process(pid)
            state = [(one.cpu_times(), one.status())
                     for one in (process, *process.children(recursive=True))]
        # roslaunch will notice, or has not started it yet.
        except (psutil.NoSuchProcess, ValueError):
            return False
        now = time.monotonic()
        before, since = self._asleep.get(name, (None, now))
        if state != before or any(status != psutil.STATUS_SLEEPING for _, status in state):
            since = now
        self._asleep[name] = state, since
        return now - since > HELPER_TIME


def registered():
    """Return the names of all nodes that the master knows, without a leading slash."""
    state = rosgraph.Master(rospy.get_name()).getSystemState()
    return {name.lstrip('/') for kind in state for _, names in kind for name in names}
