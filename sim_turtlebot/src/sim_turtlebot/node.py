"""The ROS node: it builds the simulation that its parameters ask for, and runs it."""

from odometry_common.node import leave
from odometry_common.parameters import ParameterError

from sim_turtlebot.odometry import EncoderOdometry, WorldOdometry
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulation import Simulation, side_by_side
from sim_turtlebot.simulator import Simulator
from sim_turtlebot.window import NoScreenError
from sim_turtlebot.world_file import WorldFileError


def _new_simulation(settings):
    return Simulation(side_by_side(settings.robots, settings.x, settings.y, settings.yaw),
                      lambda index: _new_odometry(settings, index), settings.odom_rate,
                      settings.cmd_vel_timeout, settings.gui, settings.world)


def _new_odometry(settings, index):
    if settings.odometry_source == 'world':
        return WorldOdometry()
    return EncoderOdometry(settings.gyro, settings.wheel_slip, settings.wheel_noise,
                           settings.gyro_noise, seed=settings.seed + index)


def simulate():
    """Simulate until shutdown, as the parameters say."""
    settings = read_settings()
    try:
        simulator = Simulator(_new_simulation(settings), settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false where {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    simulator.run()
    if settings.gui:
        leave()  # PyBullet would wait for its window's thread, which may not end
