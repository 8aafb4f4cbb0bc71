"""The output of roslaunch and its nodes, and how the nodes have ended."""

import collections
import os
import re
import signal

COLOUR = re.compile(r'\x1b\[[0-9;]*m|\x1b\]2;[^\x07]*\x07')
# Complaints of a node about its parameters, and of roslaunch about its arguments.
COMPLAINT = re.compile(r'(sim_turtlebot|test_movement|rotate_robot|movement_detector_node|view'
                       r'|RLException|Resource not found): ')
DIED = re.compile(r'\[(\w+)-\d+\] process has (?:died \[pid \d+, exit code (-?\d+)|finished)'
                  r'|=*REQUIRED process \[(\w+)-\d+\] has died!')
LAST_LINES = 5


class LaunchLog:
    """The output of roslaunch and its nodes, in memory because the disk may be full."""

    def __init__(self):
        """Begin empty."""
        self.file = os.fdopen(os.memfd_create('roslaunch'), 'wb')
        # A second open file has its own position for reading.
        self._reader = os.fdopen(
            os.open(f'/proc/self/fd/{self.file.fileno()}', os.O_RDONLY), errors='replace')
        self._last = collections.deque(maxlen=LAST_LINES)
        self.complaint = None
        self.ended = {}  # how nodes have ended, by name; '': normally

    def read(self):
        """Note what has been printed since the last call."""
        for line in self._reader:
            self._note(COLOUR.sub('', line).strip())

    def reason(self):
        """Return the complaint of a node or of roslaunch, or else the last lines."""
        return self.complaint or '\n'.join(['', *self._last])

    def _note(self, line):
        if line:
            self._last.append(line)
        if COMPLAINT.match(line):
            self.complaint = line
        found = DIED.match(line)
        if found:
            name, status, required = found.groups()
            self.ended[name or required] = _how(int(status or 0))


def _how(status):
    """Describe how a process has ended."""
    if status < 0:
        return f' by {signal.Signals(-status).name}'
    return f' with status {status}' if status else ''
