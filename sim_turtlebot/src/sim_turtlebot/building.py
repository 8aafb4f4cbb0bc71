"""The simulation that the parameters ask for."""

import random

from sim_turtlebot.gyro import Gyro
from sim_turtlebot.odometry import EncoderOdometry, WorldOdometry
from sim_turtlebot.physics import settled_world
from sim_turtlebot.scanner import Scanner
from sim_turtlebot.simulation import Simulation, side_by_side


def new_simulation(settings, build_world=settled_world, gyro=True):
    """Return the Simulation for what read_settings() returns; `build_world` is as for it.

    :param gyro: whether a robot has a gyro even if its odometry does without
    """
    return Simulation(side_by_side(settings.robots, settings.x, settings.y, settings.yaw),
                      lambda index: _new_odometry(settings, index, gyro), settings.odom_rate,
                      settings.cmd_vel_timeout, settings.gui, settings.world, settings.clock_rate,
                      build_world)


def new_scanners(simulation, settings):
    """Return the Scanner of each robot of a Simulation; none if they are not wanted."""
    if not settings.scan:
        return []
    # Numpy's seeds are not negative.
    return [Scanner(robot.body, settings.scan_beams, settings.scan_fov, settings.scan_range_min,
                    settings.scan_range_max, settings.scan_noise, (settings.seed % 2**32, index))
            for index, robot in enumerate(simulation.robots)]


def _new_odometry(settings, index, gyro):
    errors_of_gyro, seed = (settings.gyro_noise, settings.gyro_drift), settings.seed + index
    if settings.odometry_source == 'world':
        return WorldOdometry(Gyro(*errors_of_gyro, random.Random(seed)) if gyro else None)
    return EncoderOdometry(settings.gyro, settings.wheel_slip, settings.wheel_noise,
                           *errors_of_gyro, seed)
