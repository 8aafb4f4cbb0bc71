"""TurtleBots without ROS: PyBullet alone, which is the limit, and the simulator's robots."""

import time

from odometry_tests.simulation import settings_of
from sim_turtlebot.simulation import Simulation

ODOM_RATE = 20.0  # Hz, the simulator's default
SPEED = 0.1  # m/s, as test_movement drives


class BareWorld:
    """A robot that drives, and nothing but physics steps, with a call of PyBullet for each."""

    def __init__(self):
        simulation = Simulation(settings_of(odom_rate=ODOM_RATE))
        self._world, self._step_rate = simulation.world, simulation.timeline.step_rate
        self._world.step()  # from here on there is one step in a call
        self._step = self._world.client.stepSimulation
        simulation.robots[0].body.drive(SPEED, SPEED)

    def step_to_odometry(self):
        """Step for an odometry period."""
        for _ in range(round(self._step_rate / ODOM_RATE)):
            self._step()

    def speed(self, window):
        """Return the simulated seconds per second in a window (s of wall time)."""
        step, steps, duration, start = self._step, 0, 0.0, time.perf_counter()
        while not steps or duration < window:
            for _ in range(100):
                step()
            steps += 100
            duration = time.perf_counter() - start
        return steps / self._step_rate / duration


class RobotWorld:
    """A robot that is commanded after each odometry, as a controller in lockstep would."""

    def __init__(self):
        self._simulation = Simulation(settings_of(odom_rate=ODOM_RATE))
        self.robot = self._simulation.robots[0]
        self.command(SPEED)

    def command(self, speed):
        """Command the robot to go at so many m/s."""
        self._simulation.command(speed, 0.0)

    def run_to_odometry(self):
        """Step until the next odometry is there."""
        while not self._simulation.advance():
            pass

    def speed(self, window):
        """Return the simulated seconds per second in a window (s of wall time)."""
        ticks, duration, start = 0, 0.0, time.perf_counter()
        while not ticks or duration < window:
            self.run_to_odometry()
            self.command(SPEED)
            ticks += 1
            duration = time.perf_counter() - start
        return ticks / ODOM_RATE / duration
