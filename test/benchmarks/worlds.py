"""TurtleBots without ROS: PyBullet alone, which is the limit, and the simulator's robots."""

import concurrent.futures
import contextlib
import multiprocessing
import time

from odometry_tests.simulation import settings_of
from sim_turtlebot.simulation import Simulation

ODOM_RATE = 20.0  # Hz, the simulator's default
SPEED = 0.1  # m/s, as test_movement drives


def speed_of(run_to_odometry, window):
    """Call a function once per odometry period; return the simulated seconds per second.

    :param window: s of wall time; once at least
    """
    periods, duration, start = 0, 0.0, time.perf_counter()
    while not periods or duration < window:
        run_to_odometry()
        periods += 1
        duration = time.perf_counter() - start
    return periods / ODOM_RATE / duration


class BareWorld:
    """A robot that drives, and nothing but physics steps, with a call of PyBullet for each."""

    def __init__(self):
        simulation = Simulation(settings_of(odom_rate=ODOM_RATE))
        self._world, self._steps = simulation.world, round(simulation.timeline.step_rate / ODOM_RATE)
        self._world.step()  # from here on there is one step in a call
        simulation.robots[0].body.drive(SPEED, SPEED)

    def run_to_odometry(self):
        step = self._world.client.stepSimulation
        for _ in range(self._steps):
            step()

    def speed(self, window):
        return speed_of(self.run_to_odometry, window)


@contextlib.contextmanager
def bare_worlds(count):
    """Yield a function of s of wall time: the speed of so many bare worlds at once (simulated s/s)."""
    def speed(window):
        return sum(executor.map(_bare_speed, [window] * count))

    with concurrent.futures.ProcessPoolExecutor(count, multiprocessing.get_context('spawn')) as executor:
        speed(0.0)  # starts them
        yield speed


def _bare_speed(window):
    return BareWorld().speed(window)


class RobotWorld:
    """A robot that is commanded after each odometry, as a controller in lockstep would."""

    def __init__(self):
        self._simulation = Simulation(settings_of(odom_rate=ODOM_RATE))

    def run_to_odometry(self):
        self._simulation.robots[0].command(SPEED, 0.0)
        while not self._simulation.advance():
            pass

    def speed(self, window):
        return speed_of(self.run_to_odometry, window)
