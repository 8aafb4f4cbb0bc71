"""Help text, checks of the command line, and warnings about unknown names."""

import os
import sys
import xmlrpc.client

import rospy
import yaml

from odometry_common.parameters import ParameterError

HELP = {'-h', '--help'}


def show_help_if_asked(documentation, parameters):
    """If the command line contains --help, print a node's documentation and Parameters, and exit."""
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


def _private_parameters():
    """Return the names of the parameters set in the node's namespace, not below it."""
    values = rospy.get_param(rospy.get_name(), {})
    if not isinstance(values, dict):
        return []
    return sorted(f'~{name}' for name, value in values.items() if not isinstance(value, dict))


def check_command_line():
    """Raise ParameterError for a ``_name:=value`` that ROS cannot store.

    rospy uploads these by XML-RPC while the node starts, and exits with a traceback for an empty
    value, broken YAML, a large integer or a date.
    """
    for name, text in _given_parameters():
        try:
            xmlrpc.client.dumps((yaml.safe_load(text),))
        except (yaml.YAMLError, TypeError, ValueError, OverflowError, RecursionError):
            raise ParameterError(
                name, text, 'a value that ROS can store: a string, a number with '
                'at most 32 bits or a decimal point, true or false, or a list of them') from None


def _given_parameters():
    """Yield the name, such as ~speed, and the text of each ``_name:=value`` argument."""
    for argument in sys.argv[1:]:
        name, separator, text = argument.partition(':=')
        if separator and name.startswith('_') and not name.startswith('__'):
            yield f'~{name[1:]}', text
