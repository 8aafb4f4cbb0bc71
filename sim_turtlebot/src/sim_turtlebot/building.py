"""The simulation that the parameters ask for."""

from sim_turtlebot.odometry import EncoderOdometry, WorldOdometry
from sim_turtlebot.simulation import Simulation, side_by_side


def new_simulation(settings, client=None):
    """Return the Simulation for what read_settings() returns; `client` is as for its World."""
    return Simulation(side_by_side(settings.robots, settings.x, settings.y, settings.yaw),
                      lambda index: _new_odometry(settings, index), settings.odom_rate,
                      settings.cmd_vel_timeout, settings.gui, settings.world, client,
                      settings.clock_rate)


def _new_odometry(settings, index):
    errors_of_gyro = settings.gyro_noise, settings.gyro_drift, settings.seed + index
    if settings.odometry_source == 'world':
        return WorldOdometry(*errors_of_gyro)
    return EncoderOdometry(settings.gyro, settings.wheel_slip, settings.wheel_noise, *errors_of_gyro)
