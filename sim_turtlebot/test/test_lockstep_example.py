"""The example of docs/ci.md, whose node knows nothing of lockstep, beside load."""

import contextlib
import os
import sys
from functools import partial

import pytest
from geometry_msgs.msg import Twist
from lockstep_runs import assert_same_bytes, record
from nav_msgs.msg import Odometry
from odometry_tests.processes import Process
from odometry_tests.scripts import ROOT
from tf2_msgs.msg import TFMessage

RUNS = 20
DRIVEN = 6  # s of simulated time; a metre takes five
TOPICS = {'/odom': (Odometry, 20 * DRIVEN), '/tf': (TFMessage, 20 * DRIVEN),
          '/cmd_vel': (Twist, 10 * DRIVEN)}
BUSY = 'while True: pass'


@pytest.fixture
def load():
    """Have a process for each processor compute."""
    with contextlib.ExitStack() as stack:
        for _ in range(os.cpu_count()):
            stack.enter_context(Process(sys.executable, '-c', BUSY))
        yield


@pytest.mark.nightly
def test_twenty_runs_beside_load_are_the_same_bytes(simulated_time, load):
    """With the default clock; and each stops where the example's test expects it."""
    start = partial(Process, sys.executable, ROOT / 'docs' / 'example' / 'src' / 'one_metre.py',
                    '__name:=one_metre')
    first, *others = (record([start], TOPICS, ['_clock_rate:=100']) for _ in range(RUNS))
    assert first['/odom'][-1].pose.pose.position.x == pytest.approx(1.015, abs=0.015)
    for other in others:
        assert_same_bytes(first, other)
