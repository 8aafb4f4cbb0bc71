"""From Ctrl-C to the end of the detector, beside a node of bare rospy."""

import time
from pathlib import Path

from measuring import Target, in_turns
from odometry_tests.processes import Process
from odometry_tests.tutorial import detector

NAME, UNIT, TARGET = 'end of a node', 's', Target('<=', 1.25)
RELAY = Path(__file__).parents[1] / 'relay.py'
TIMEOUT = 60.0  # s


def measure(options):
    return in_turns(options, lambda: _end(detector(), 'waiting for odometry'),
                    lambda: _end(Process('python3', RELAY, '/question', '/answer'), 'ready'))


def _end(process, word):
    """Return the time (s) that a node needs to end once it has said a word.

    rospy itself may never end if Ctrl-C comes while it registers a topic.
    """
    with process:
        process.wait_for_output(word, TIMEOUT)
        begin = time.perf_counter()
        process.end()
        return time.perf_counter() - begin
