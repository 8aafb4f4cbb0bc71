"""A node's --help, and its warnings about what it does not know."""

import os
import sys

import rospy

from odometry_common.command_line import forget_argument

HELP = {'-h', '--help'}


def show_help_if_asked(documentation, parameters):
    """Print a node's documentation and its Parameters, and exit, if the command line asks for it."""
    if HELP.intersection(sys.argv[1:]):
        program = os.path.basename(sys.argv[0])
        print(f'usage: {program} [NAME:=OTHER_NAME...] [_PARAMETER:=VALUE...]\n\n'
              f'{documentation.strip()}\n\n{parameters.help}'.rstrip())
        sys.exit(0)


def warn_of_unknown(parameters):
    """Warn of arguments, and of private parameters that are not among the Parameters."""
    arguments = rospy.myargv()[1:]
    if arguments:
        rospy.logwarn(f'ignored: {", ".join(map(repr, arguments))}; see --help')
    unknown = [name for name in _private_parameters() if name not in parameters.names]
    if unknown:
        rospy.logwarn(f'unknown: {", ".join(unknown)}; the parameters of this node are '
                      f'{", ".join(parameters.names) or "none"}')
    for name in unknown:
        forget_argument(name)


def _private_parameters():
    """Return the names of what is set in the node's namespace, but not below that."""
    values = rospy.get_param(rospy.get_name(), {})
    if not isinstance(values, dict):
        return []
    return sorted(f'~{name}' for name, value in values.items() if not isinstance(value, dict))
