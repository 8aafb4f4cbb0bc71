"""The ROS node: it builds the simulation that its parameters ask for, and runs it."""

from odometry_common.parameters import ParameterError

from sim_turtlebot.building import new_simulation
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulator import Simulator
from sim_turtlebot.window import NoScreenError
from sim_turtlebot.world_file import WorldFileError


def simulate():
    """Simulate until shutdown, as the parameters say."""
    settings = read_settings()
    try:
        simulator = Simulator(new_simulation(settings), settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false where {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    simulator.run()
