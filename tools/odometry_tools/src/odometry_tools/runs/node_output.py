"""The output of the nodes of a launch file."""

import os
import re
import signal

from odometry_common.native_output import redirected_output

LAST_LINES = 5
EXCEPTION = re.compile(r'[\w.]*(Error|Exception)(: |$)')


class NodeOutput:
    """The output of child processes; in memory, since the disk may be full."""

    def __init__(self):
        self._file = os.memfd_create('nodes', os.MFD_CLOEXEC)

    def capture(self):
        """Return a context that captures the output of this process and of those it starts."""
        return redirected_output(self._file)

    def add(self, line):
        """Add a line of this process."""
        os.write(self._file, f'{line}\n'.encode())

    def close(self):
        """Forget the output."""
        os.close(self._file)

    def lines(self):
        """Return all lines but empty ones."""
        size = os.fstat(self._file).st_size
        text = os.pread(self._file, size, 0).decode(errors='replace')
        return [line for line in map(str.strip, text.splitlines()) if line]

    def complaint_of(self, node):
        """Return the last line that begins with a node's name, as its errors do, or None."""
        return next((line for line in reversed(self.lines())
                     if line.startswith(f'{node}: ')), None)

    def last_exception(self):
        """Return words with the last line that ends a traceback, of whichever node; or ''."""
        return next((f'; last error printed: {line}' for line in reversed(self.lines())
                     if EXCEPTION.match(line)), '')

    def last_lines(self):
        """Return the last lines, each after a line break."""
        return '\n'.join(['', *self.lines()[-LAST_LINES:]])


def end_in_words(status):
    """Describe an exit code, after "has ended"."""
    if status is None:
        return ' before it started'
    if status < 0:
        names = {signum.value: signum.name for signum in signal.Signals}
        return f' by {names.get(-status, f"signal {-status}")}'
    return f' with status {status}' if status else ''
