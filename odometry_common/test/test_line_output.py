"""Lines of a node whose output nobody reads."""

import os
from concurrent.futures import ThreadPoolExecutor

from odometry_common.output import LineOutput


def test_two_threads_that_print_into_a_full_pipe_both_go_on():
    """As the callback and the loop of main.py, when `less` shows its first page."""
    reader, writer = os.pipe()
    with os.fdopen(reader), os.fdopen(writer, 'w') as stream:
        output = LineOutput(stream, lambda: None)
        os.write(writer, bytes(2**16))  # Linux's pipes hold as much
        with ThreadPoolExecutor(2) as threads:
            assert list(threads.map(output.write, ['one\n', 'two\n'])) == [4, 4]
