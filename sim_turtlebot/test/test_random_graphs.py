"""In lockstep two runs are the same bytes, whatever two to eight nodes do."""

import random
import sys
from functools import partial
from pathlib import Path

import pytest
from geometry_msgs.msg import Twist
from lockstep_runs import assert_same_bytes, record, started_client
from nav_msgs.msg import Odometry

CLIENT = Path(__file__).with_name('random_client.py')
GRAPHS = 200
TIME = 3  # s of simulated time
MOST_NODES = 8


@pytest.mark.nightly
@pytest.mark.parametrize('graph', range(GRAPHS))
def test_two_runs_of_a_random_graph_are_the_same_bytes(simulated_time, graph):
    nodes = random.Random(graph).randint(2, MOST_NODES)
    starts = [partial(started_client, sys.executable, CLIENT, graph, node, nodes, f'__name:=random_{node}')
              for node in range(nodes)]
    topics = {'/odom': (Odometry, 20 * TIME), '/cmd_vel': (Twist, 3 * TIME)}
    assert_same_bytes(*(record(starts, topics, ['_clock_rate:=100']) for _ in range(2)))
