"""Read launch files, as roslaunch does."""

from rosgraph.names import ns_join
from roslaunch.config import load_config_default
from roslaunch.core import RLException
from roslaunch.rlutil import resolve_launch_arguments


def load(package, name, arguments, port=None):
    """Return roslaunch's configuration of a launch file in a package."""
    source = path_of(package, name), [f'{key}:={value}' for key, value in arguments.items()]
    return load_config_default([source], port, assign_machines=port is not None)


def path_of(package, name):
    """Return the path of a launch file; roslaunch.RLException: there is none."""
    path, *others = resolve_launch_arguments([package, name])
    if others:
        raise RLException(f'there is no package {package}')
    return path


def name_of(node):
    """Return the name of a node in a configuration, as roslaunch names its process."""
    return ns_join(node.namespace, node.name).lstrip('/')
