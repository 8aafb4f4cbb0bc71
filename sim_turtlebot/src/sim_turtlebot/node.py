"""The ROS node: it builds the simulation that its parameters ask for, and runs it."""

import threading

import rospy
from odometry_common.node import leave
from odometry_common.parameters import ParameterError

from sim_turtlebot.building import new_simulation
from sim_turtlebot.settings import read_settings
from sim_turtlebot.simulator import Simulator
from sim_turtlebot.window import NoScreenError
from sim_turtlebot.world_file import WorldFileError

LOOK_PERIOD = 0.1  # s


def simulate():
    """Simulate until shutdown, as the parameters say."""
    settings = read_settings()
    built = threading.Event()
    threading.Thread(target=_leave_while_building, args=[built], daemon=True).start()
    try:
        simulator = Simulator(new_simulation(settings), settings)
    except NoScreenError as error:
        raise ParameterError('~gui', True, f'false where {error}') from None
    except WorldFileError as error:
        raise ParameterError('~world', settings.world, error) from None
    finally:
        built.set()
    simulator.run()
    if settings.gui:
        leave()  # PyBullet would wait for its window's thread, which may not end


def _leave_while_building(built):
    """End the process at a shutdown that comes while PyBullet loads a world, which may take long."""
    while not built.wait(LOOK_PERIOD):
        if rospy.core.is_shutdown_requested():
            leave()
