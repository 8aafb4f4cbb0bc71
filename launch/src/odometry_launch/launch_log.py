"""What roslaunch and its nodes print, and what it means."""

import collections
import os
import re
import signal

COLOUR = re.compile(r'\x1b\[[0-9;]*m|\x1b\]2;[^\x07]*\x07')
# How a node complains of its parameters, and roslaunch of what it is given.
COMPLAINT = re.compile(r'(sim_turtlebot|test_movement|rotate_robot|movement_detector_node|view'
                       r'|RLException|Resource not found): ')
ENDED = re.compile(r'\[(\w+)-\d+\] process has (?:died \[pid \d+, exit code (-?\d+)|finished)')
REQUIRED_ENDED = re.compile(r'=*REQUIRED process \[(\w+)-\d+\] has died!')
LAST_LINES = 5


class LaunchLog:
    """A file for roslaunch to print to; in memory, since a disk may be full."""

    def __init__(self):
        """Begin empty."""
        self.file = os.fdopen(os.memfd_create('roslaunch'), 'wb')
        self._place = 0
        self._rest = b''
        self._last = collections.deque(maxlen=LAST_LINES)
        self.complaint = None  # what a node or roslaunch has said against its arguments
        self.ended = {}  # how nodes have ended, by name: '' if well

    def read(self):
        """Note what has been printed since the last time."""
        # Who prints has the same place in the file.
        descriptor = self.file.fileno()
        new = os.pread(descriptor, os.fstat(descriptor).st_size - self._place, self._place)
        self._place += len(new)
        *lines, self._rest = (self._rest + new).split(b'\n')
        for line in lines:
            self._note(COLOUR.sub('', line.decode(errors='replace')).strip())

    def reason(self):
        """Return the complaint, or else the last lines."""
        return self.complaint or '\n'.join(['', *self._last])

    def _note(self, line):
        if line:
            self._last.append(line)
        if COMPLAINT.match(line):
            self.complaint = line
        found = ENDED.match(line) or REQUIRED_ENDED.match(line)
        if found:
            self.ended[found[1]] = _how(*found.groups()[1:])


def _how(status=None):
    """Return in words how a process has ended; take its exit status as a text."""
    if status is None or int(status) == 0:
        return ''
    if int(status) < 0:
        return f' by {signal.Signals(-int(status)).name}'
    return f' with status {status}'
