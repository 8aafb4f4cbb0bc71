"""A tutorial's loop and its robot in one process, bit-identical to the nodes in lockstep."""

import functools
import threading

from sim_turtlebot.physics.world import World
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation

from odometry_tools.runs.tutorials import TUTORIALS, follow

# A Dask worker has several threads, but PyBullet and its world belong to the process.
_run_lock = threading.Lock()


def run(tutorial, parameters):
    """Run a tutorial with parameter values by name; return its metrics by name."""
    with _run_lock:
        loop, settings = TUTORIALS[tutorial](parameters), read_settings(parameters)
        settings.clock_rate = settings.odom_rate  # as for the nodes
        simulation = Simulation(settings, build_world=_world)
        return follow(loop, _ticks(simulation), simulation.robots[0].command)


def _ticks(simulation):
    robot, timeline = simulation.robots[0], simulation.timeline
    while True:
        seconds, nanoseconds = divmod(timeline.now, 10**9)
        yield seconds + nanoseconds / 1e9, robot.odometry, robot.ground_truth
        while not simulation.advance():
            pass


_cached_world = functools.lru_cache(maxsize=1)(World)


def _world(step_rate, starts, gui, world_file):
    """Return a World whose robots are at their starts; reuse that of the last run if possible.

    Building one takes a tenth as long as a drive of two metres. In a world with a file, other
    things may have moved, too.
    """
    world = _cached_world(step_rate, tuple(starts), gui, world_file)
    (world.rebuild if world_file else world.restart)()
    return world
