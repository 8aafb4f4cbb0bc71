"""Redirect what this process prints, also from C++ and from child processes."""

import contextlib
import ctypes
import os
import sys


@contextlib.contextmanager
def redirected_output(descriptor):
    """Meanwhile send stdout and stderr to an open file descriptor."""
    sys.stdout.flush()
    sys.stderr.flush()
    own = {stream: os.dup(stream) for stream in (1, 2)}
    try:
        for stream in own:
            os.dup2(descriptor, stream)
        yield
    finally:
        ctypes.CDLL(None).fflush(None)  # C++ has its own buffer
        for stream, copy in own.items():
            os.dup2(copy, stream)
            os.close(copy)


@contextlib.contextmanager
def suppressed_output():
    """Meanwhile discard stdout and stderr."""
    with open(os.devnull, 'wb') as nothing, redirected_output(nothing.fileno()):
        yield
