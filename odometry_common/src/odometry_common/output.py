"""Output that appears line by line and never blocks a node."""

import os
import select

PATIENCE = 100  # ms, for a reader to make room


class LineOutput:
    """A text stream that passes on whole lines, each at once.

    Without a terminal Python buffers a node's output until it exits, and ``roslaunch ... | tee``
    shows nothing. And its writes block while the reader is stuck, as with ``| less`` or after
    Ctrl-S: here the node continues, and those lines are lost.
    """

    def __init__(self, stream, on_closed):
        """Write to a stream; call on_closed once if its reader goes, as in ``rosrun ... | head``."""
        # Python has no stream where the parent process has closed it.
        self._stream = stream or os.fdopen(os.open(os.devnull, os.O_WRONLY), 'w')
        self._on_closed = on_closed
        self._line = ''
        self._timeout = PATIENCE

    def write(self, text):
        """Write text; without a reader this is no error."""
        self._line += text
        if '\n' in text:
            self.flush()
        return len(text)

    def flush(self):
        """Pass on what has been written."""
        text, self._line = self._line, ''
        data = text.encode(self._stream.encoding, self._stream.errors)
        try:
            while data and self._has_room():
                data = data[os.write(self._stream.fileno(), data[:select.PIPE_BUF]):]
        except BrokenPipeError:
            on_closed, self._on_closed = self._on_closed, lambda: None
            on_closed()
        except OSError:  # the disk is full, or the terminal gone
            pass

    def _has_room(self):
        """Return whether a write of PIPE_BUF bytes would not wait; wait only while it helps."""
        poll = select.poll()  # one for each call: two threads may print
        poll.register(self._stream.fileno(), select.POLLOUT)
        has_room = bool(poll.poll(self._timeout))
        self._timeout = PATIENCE if has_room else 0
        return has_room

    def __getattr__(self, name):
        """Be the stream in all other respects."""
        return getattr(self._stream, name)
