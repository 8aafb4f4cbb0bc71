"""Read launch files, as roslaunch does."""

import contextlib
import os
import sys

from odometry_common.parameters import StartError
from rosgraph.names import ns_join
from roslaunch.arg_dump import get_args
from roslaunch.config import load_config_default
from roslaunch.core import RLException
from roslaunch.rlutil import resolve_launch_arguments

SIMULATOR = 'sim_turtlebot'  # the name of the robot's node


def load(path, arguments, port=None):
    """Return roslaunch's configuration of a launch file with arguments (`name:=value`)."""
    return load_config_default([(path, arguments)], port, assign_machines=port is not None)


def nodes_beside_robot(path, arguments):
    """Return the nodes of a launch file; StartError: unreadable, or it starts its own robot."""
    name = os.path.basename(path)
    with refused(name):
        nodes = load(path, arguments).nodes
    if any(node.type == 'sim_turtlebot_node.py' for node in nodes):
        raise StartError(f'{name} starts a robot, but there is one already: leave out sim.launch')
    if any(name_of(node) == SIMULATOR for node in nodes):
        raise StartError(f'{name}: a node has the name of the robot, {SIMULATOR}: give it another')
    return nodes


@contextlib.contextmanager
def refused(name):
    """Turn each error into a StartError about a launch file, in one line."""
    try:
        yield
    except Exception as error:  # noqa: BLE001
        # $(eval) and $(find) may raise any.
        text, lists_folders, _ = str(error).partition('ROS path [')
        reason = ' '.join(text.split()) or repr(error)
        missing = 'there is no package ' if lists_folders else ''
        raise StartError(f'{name}: {missing}{reason}') from None


def path_of(package, name):
    """Return the path of a launch file; roslaunch.RLException: there is none."""
    path, *others = resolve_launch_arguments([package, name])
    if others:
        raise RLException(f'there is no package {package}')
    return path


def name_of(node):
    """Return the name of a node in a configuration, as roslaunch names its process."""
    return ns_join(node.namespace, node.name).lstrip('/')


def _check_names(path, arguments):
    """Raise StartError for an argument that a launch file does not have: roslaunch ignores it."""
    known = get_args([path])
    for argument in arguments:
        name, _, _ = argument.partition(':=')
        if name not in known:
            raise StartError(f'{os.path.basename(path)} has no argument {name}; '
                             f'it has {", ".join(sorted(known)) or "none"}')


def main():
    """Exit, if the file and the arguments of the command line cannot run beside a robot."""
    path, *arguments = sys.argv[1:]
    try:
        nodes_beside_robot(path, arguments)
        _check_names(path, arguments)
    except StartError as refusal:
        sys.exit(str(refusal))
