"""A tutorial's loop in one process: what a graph in lockstep does, to the last bit."""

import functools
import threading
from typing import NamedTuple

from odometry_common.geometry import is_upright
from sim_turtlebot.building import new_simulation
from sim_turtlebot.odometry import Motion
from sim_turtlebot.physics import connect, settled_world

from odometry_sweep.reading import read

ARRIVED, LATE, FALLEN = 'arrived', 'late', 'fallen'  # why a run ended

# A process has one PyBullet and one source of parameters, but a Dask worker several threads.
_one_at_a_time = threading.Lock()


class Tick(NamedTuple):
    """What there is to know at an odometry."""

    stamp: float  # s, as rospy has it
    odometry: Motion
    ground_truth: Motion


def run(tutorial, parameters):
    """Run a tutorial, with parameter values by their names; return its figures by theirs."""
    with _one_at_a_time:
        part, settings = read(tutorial, parameters)
        simulation = new_simulation(settings, _world, gyro=False)
        return follow(part, _ticks(simulation), simulation.command)


def follow(part, ticks, command):
    """Let a tutorial's part answer each Tick; return the figures at its end.

    :param command: function that takes each answer, m/s and rad/s
    """
    start = None
    for stamp, odometry, ground_truth in ticks:
        start = start or ground_truth
        answer = part.answer(stamp, odometry)
        if answer:
            command(*answer)
        arrived = part.arrived(ground_truth)
        if arrived or stamp > part.longest:
            break
    upright = is_upright(ground_truth.orientation)
    ended = ARRIVED if arrived else LATE if upright else FALLEN
    return {**part.figures(start, ground_truth), 'time': stamp, 'ended': ended}


def _world(step_rate, starts, _gui, world_file):
    """Return a World whose robots stand at their starts; that of the last run if it can be.

    To build one takes a tenth as long as a drive of two metres. In one that a file has filled, more
    than the robots may have moved.
    """
    if world_file:
        return settled_world(step_rate, starts, world_file=world_file, client=_client(filled=True))
    world = _world_of_robots(step_rate, tuple(starts))
    world.restart()
    return world


@functools.lru_cache(maxsize=1)
def _world_of_robots(step_rate, starts):
    return settled_world(step_rate, starts, client=_client(filled=False))


@functools.lru_cache(maxsize=None)
def _client(filled):
    """Return this process's PyBullet for the worlds that a file fills, or for all others.

    To connect takes longer than to build a world.
    """
    return connect()


def _ticks(simulation):
    robot, timeline = simulation.robots[0], simulation.timeline
    while True:
        seconds, nanoseconds = divmod(timeline.now, 10**9)
        yield Tick(seconds + nanoseconds / 1e9, robot.odometry, robot.ground_truth)
        while not simulation.advance():
            pass
