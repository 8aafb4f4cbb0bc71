"""Help text, checks of the command line, and warnings about unknown names."""

import contextlib
import os
import re
import sys
import xmlrpc.client

import rospy
import yaml
from rosgraph.names import is_legal_name

from odometry_common.connections import NO_ANSWER
from odometry_common.parameters import ParameterError, StartError

HELP = {'-h', '--help'}
LAUNCHED = '__log:='  # only roslaunch gives it
# Name and text of a parameter on the command line.
GIVEN = re.compile(r'_(?!_)(.*?):=(.*)', re.DOTALL)


def show_help_if_asked(documentation, parameters):
    """If --help is given, print a node's documentation and Parameters, once, and exit."""
    if HELP.intersection(sys.argv[1:]):
        program = os.path.basename(sys.argv[0])
        table = '' if parameters.help in documentation else parameters.help
        print(f'usage: {program} [NAME:=OTHER_NAME...] [_PARAMETER:=VALUE...]\n\n'
              f'{documentation.strip()}\n\n{table}'.rstrip())
        sys.exit(0)


def warn_of_unknown(parameters):
    """Warn of private parameters that are not among the Parameters."""
    values = rospy.get_param(rospy.get_name(), {})
    given = values.items() if isinstance(values, dict) else ()
    names = {f'~{name}' for name, value in given if not isinstance(value, dict)}
    unknown = sorted(names - {*parameters.names})
    if unknown:
        rospy.logwarn(f'unknown: {", ".join(unknown)}{how_to_forget(unknown[0])}; '
                      f'the parameters of this node are {", ".join(parameters.names) or "none"}')


def check_command_line(parameters):
    """Raise StartError for what is no parameter, as ParameterError if ROS cannot store its value.

    rospy uploads parameters by XML-RPC while the node starts, and exits with a traceback for an
    empty value, broken YAML, a large integer or a date.
    """
    names = {name.lstrip('~') for name in parameters.names}
    for word in sys.argv[1:]:
        name, is_remapping, other = word.partition(':=')
        # A topic may have the name of a parameter.
        is_value = not is_legal_name(other) or isinstance(yaml.safe_load(other), bool)
        if not is_remapping or name in names and is_value:
            raise StartError(f'{word!r} is no parameter: write _NAME:=VALUE; see --help')
    for name, text in (given.groups() for given in map(GIVEN.fullmatch, sys.argv[1:]) if given):
        try:
            xmlrpc.client.dumps((yaml.safe_load(text),))
        except (yaml.YAMLError, TypeError, ValueError, OverflowError, RecursionError):
            raise ParameterError(
                f'~{name}', text, 'a value that ROS can store: a string, a number with '
                'at most 32 bits or a decimal point, true or false, or a list of them') from None


def how_to_forget(name):
    """Return how to remove a parameter from the master; '' if it is not there.

    Not of a launch file's node, whose parameters each roslaunch sets again.
    """
    is_launched = any(word.startswith(LAUNCHED) for word in sys.argv)
    if rospy.core.is_initialized() and not is_launched:
        with contextlib.suppress(*NO_ANSWER):
            if rospy.has_param(name):
                return f'; it stays until rosparam delete {rospy.resolve_name(name)}'
    return ''
