"""A node's command line: --help, checks, and warnings about unknown names."""

import os
import sys
import xmlrpc.client

import rospy
import yaml

from odometry_common.parameters import ParameterError

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


def check_command_line(arguments=None):
    """Raise ParameterError for a ``_name:=value`` that rospy could not store.

    rospy uploads these by XML-RPC while the node starts, and answers an empty value, broken
    YAML, a large integer or a date with a traceback.
    """
    for argument in sys.argv[1:] if arguments is None else arguments:
        name, separator, text = argument.partition(':=')
        if not separator or not name.startswith('_') or name.startswith('__'):
            continue
        try:
            xmlrpc.client.dumps((yaml.safe_load(text),))
        except (yaml.YAMLError, TypeError, OverflowError, RecursionError):
            raise ParameterError(
                f'~{name[1:]}', text, 'a value that ROS can store: a string, a number with '
                'at most 32 bits or a decimal point, true or false, or a list of them') from None


def forget_argument(name):
    """Delete a parameter (such as ~speed) that the command line set, or the next run gets it, too."""
    given = any(argument.startswith(f'_{name[1:]}:=') for argument in sys.argv[1:])
    if given and rospy.core.is_initialized() and rospy.has_param(name):
        rospy.delete_param(name)
