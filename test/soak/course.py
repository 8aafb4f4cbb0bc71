"""What happens when: a random course of commands and events, the same from the same seed.

It is a row of odometry steps, PERIOD seconds each, and knows nothing of the robot.
"""

import itertools
import math
import random

RATE = 20  # Hz, of the odometry and of the lockstep
PERIOD = 1 / RATE  # s

RESET_DISTANCE = 'resets of the distance'
RESET_ODOMETRY = 'resets of the odometry'
RESET_SIMULATION = 'resets of the simulation'
PAUSE = 'pauses'
RESTART = 'restarts of the detector'
KILL = 'kills of the detector'
# How often each comes, in relation to the others.
EVENTS = {RESET_DISTANCE: 35, RESET_ODOMETRY: 30, PAUSE: 20, RESET_SIMULATION: 12,
          RESTART: 2, KILL: 1}

FIRST_GAPS = 8.0, 9.5  # s between events until each has come once: within a minute
GAPS = 10.0, 60.0  # s between events from then on
LEGS = 0.5, 10.0  # s between two changes of the commanded velocity


def course(seed):
    """Yield, for each step and without end, linear (m/s), angular (rad/s) and an event or None."""
    for (linear, angular), event in zip(_velocities(seed), _events(seed)):
        yield linear, angular, event


def _velocities(seed):
    rng = random.Random(f'velocities {seed}')
    while True:
        yield from itertools.repeat(_velocity(rng), _steps(rng, LEGS))


def _velocity(rng):
    """Draw what to do next; sometimes more than the robot can, or what it has to refuse."""
    speed, turn = rng.uniform(-0.7, 0.7), rng.uniform(-math.pi, math.pi)
    legs = {(0.0, 0.0): 2, (speed, 0.0): 3, (0.0, turn): 2, (speed, turn): 3,
            (100 * speed, 100 * turn): 1, (math.nan, turn): 0.2, (speed, math.inf): 0.2}
    return rng.choices(list(legs), legs.values())[0]


def _events(seed):
    rng = random.Random(f'events {seed}')
    for event in rng.sample(list(EVENTS), len(EVENTS)):
        yield from itertools.repeat(None, _steps(rng, FIRST_GAPS))
        yield event
    while True:
        yield from itertools.repeat(None, _steps(rng, GAPS))
        yield rng.choices(list(EVENTS), EVENTS.values())[0]


def _steps(rng, seconds):
    return round(rng.uniform(*seconds) * RATE)
