"""The output of the nodes of a launch file."""

import os

from odometry_common.native_output import redirected_output

from odometry_tools.runs.quoting import error_in

LAST_LINES = 5


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
        return [line for line in map(str.strip, self._text().splitlines()) if line]

    def complaint_of(self, node):
        """Return the last line that begins with a node's name, as its errors do, or None."""
        return next((line for line in reversed(self.lines())
                     if line.startswith(f'{node}: ')), None)

    def last_exception(self):
        """Return words with the last error of a traceback, of whichever node; or ''."""
        error = error_in(self._text())
        return error and f'; last error printed: {error}'

    def last_lines(self):
        """Return the last lines, each after a line break."""
        return '\n'.join(['', *self.lines()[-LAST_LINES:]])

    def _text(self):
        size = os.fstat(self._file).st_size
        return os.pread(self._file, size, 0).decode(errors='replace')
