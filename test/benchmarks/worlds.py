"""TurtleBots without ROS: PyBullet alone, which is the limit, and the simulator's robots."""

import math
import time

from sim_turtlebot.odometry import WorldOdometry
from sim_turtlebot.physics import World
from sim_turtlebot.robot import Robot
from sim_turtlebot.timeline import Timeline

ODOM_RATE = 20.0  # Hz, the simulator's default
SPEED = 0.1  # m/s, as test_movement drives
SPACING = 1.0  # m
TIMEOUT = 0.6  # s, the default ~cmd_vel_timeout


class BareWorld:
    """Robots that drive, and nothing but physics steps."""

    def __init__(self, robots=1):
        """Build the simulator's world and let the wheels turn."""
        self.step_rate = Timeline(ODOM_RATE).step_rate
        self.world, self.bodies = _new_world(self.step_rate, robots)
        for body in self.bodies:
            body.drive(SPEED, 0.0)

    def speed(self, window):
        """Return the simulated seconds per second in a window (s of wall time)."""
        step, steps, start = self.world.step, 0, time.perf_counter()
        while (duration := time.perf_counter() - start) < window:
            for _ in range(100):
                step()
            steps += 100
        return steps / self.step_rate / duration


class RobotWorld:
    """Robots that are commanded after each odometry, as the node's main loop would."""

    def __init__(self, robots=1):
        """Build the simulator's world with its robots."""
        self._timeline = Timeline(ODOM_RATE)
        self._world, bodies = _new_world(self._timeline.step_rate, robots)
        self.robots = [Robot(body, self._timeline.step_rate, WorldOdometry(), TIMEOUT)
                       for body in bodies]
        self.command(SPEED)

    def command(self, speed):
        """Command each robot to go at so many m/s."""
        for robot in self.robots:
            robot.command(speed, 0.0, self._timeline.steps)

    def run_to_odometry(self):
        """Step until the next odometry is there."""
        timeline, robots, step = self._timeline, self.robots, self._world.step
        for _ in range(timeline.steps_per_odometry):
            for robot in robots:
                robot.before_step(timeline.steps)
            step()
            timeline.steps += 1
        for robot in robots:
            robot.tick(timeline.steps, 1 / ODOM_RATE)

    def speed(self, window):
        """Return the simulated seconds per second in a window (s of wall time)."""
        ticks, start = 0, time.perf_counter()
        while (duration := time.perf_counter() - start) < window:
            self.run_to_odometry()
            self.command(SPEED)
            ticks += 1
        return ticks / ODOM_RATE / duration


def stop_after(distance):
    """Drive a robot whose controller answers without delay, until it has stopped.

    :return: metres moved at each odometry, added up as the detector does
    """
    world, moved, position = RobotWorld(), [0.0], (0.0, 0.0, 0.0)
    robot = world.robots[0]
    while not robot.resting:
        world.run_to_odometry()
        moved.append(moved[-1] + step_between(position, robot.odometry.position))
        position = robot.odometry.position
        world.command(SPEED if moved[-1] < distance else 0.0)
    return moved


def step_between(a, b):
    """Return the distance in the plane (m) between two positions."""
    return math.hypot(b[0] - a[0], b[1] - a[1])


def _new_world(step_rate, robots):
    world = World(step_rate)
    bodies = [world.add_turtlebot(0.0, index * SPACING) for index in range(robots)]
    world.settle()
    return world, bodies
