"""Keep the notices that PyBullet prints from C++ off the terminal."""

import contextlib
import ctypes
import os
import sys


@contextlib.contextmanager
def suppress_native_output():
    """Discard output to stdout and stderr, also from C++."""
    sys.stdout.flush()
    sys.stderr.flush()
    terminal = {stream: os.dup(stream) for stream in (1, 2)}
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for stream in terminal:
            os.dup2(nowhere, stream)
        yield
    finally:
        ctypes.CDLL(None).fflush(None)  # C++ has its own buffer
        for stream, copy in terminal.items():
            os.dup2(copy, stream)
            os.close(copy)
        os.close(nowhere)
