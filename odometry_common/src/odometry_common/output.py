"""Output that is seen as soon as a line of it is written."""

import os


class LineOutput:
    """A text stream whose lines are passed on at once, also into a pipe.

    Python keeps a node's output in a buffer until it ends if it does not go to a terminal, and
    ``roslaunch ... | tee`` would show nothing.
    """

    def __init__(self, stream, on_closed):
        """Write to a stream; on_closed is called, once, if nobody reads it any more.

        The reader of ``rosrun ... | head`` goes away while the node still has lines to print.
        """
        # Python has no stream where the parent process has closed it.
        self._stream = stream or os.fdopen(os.open(os.devnull, os.O_WRONLY), 'w')
        self._stream.reconfigure(line_buffering=True)
        self._on_closed = on_closed

    def write(self, text):
        """Write text; there is no error if nobody reads it."""
        try:
            return self._stream.write(text)
        except BrokenPipeError:
            # What the buffer still holds has to go somewhere, or it would be tried again.
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self._stream.fileno())
            os.close(nowhere)
            self._on_closed()
            return len(text)

    def __getattr__(self, name):
        """Be the stream in all other respects."""
        return getattr(self._stream, name)
