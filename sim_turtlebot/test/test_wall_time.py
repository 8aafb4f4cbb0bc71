"""Which messages lockstep takes for those of a node that sleeps by wall time."""

import itertools
import random

import pytest
from sim_turtlebot.lockstep.lockstep import MIN_INTERVALS, _follow_wall_time

TICK = 0.01  # s of simulated time
RATES = 1.0, 2.0, 10.0, 30.0, 50.0  # Hz


def named(wall, simulated):
    """Return how often lockstep would name the node, by the intervals (s) between its messages."""
    times = list(zip(itertools.accumulate(wall), itertools.accumulate(simulated)))
    return sum(_follow_wall_time(times[end - MIN_INTERVALS - 1:end], TICK)
               for end in range(MIN_INTERVALS + 1, len(times)))


@pytest.mark.parametrize('pace', [1.0, 20.0])
@pytest.mark.parametrize('rate', RATES)
def test_a_loop_in_simulated_time_is_never_one(rate, pace):
    """On a machine on which a tick takes up to ten times as long as another one."""
    rng = random.Random(rate)
    ends = [round(number / rate / TICK) for number in range(20_000)]
    simulated = [TICK * (end - begin) for begin, end in zip(ends, ends[1:])]
    wall = [sum(TICK / pace * rng.uniform(0.2, 2.0) for _ in range(round(interval / TICK)))
            for interval in simulated]
    assert not named(wall, simulated)


@pytest.mark.parametrize('nap', [0.03, 0.1, 0.5, 2.0])
def test_a_loop_with_time_sleep_is_soon_one(nap):
    """On a machine whose speed varies; it oversleeps by up to a millisecond."""
    rng = random.Random(nap)
    wall = [nap + rng.uniform(0.0, 0.001) for _ in range(50)]
    simulated = [TICK * round(nap * rng.uniform(10, 20) / TICK) for _ in wall]
    assert named(wall, simulated)
