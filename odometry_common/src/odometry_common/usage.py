"""What a node says of itself: its help, and what it was given but does not know."""

import os
import re
import sys

import rospy

from odometry_common.parameters import forget_argument

HELP = {'-h', '--help'}
PARAMETER = re.compile(r'^    (~.*?) \(', re.MULTILINE)


def show_help_if_asked(documentation):
    """Print a node's documentation and end the process, if the command line asks for it."""
    if HELP.intersection(sys.argv[1:]):
        program = os.path.basename(sys.argv[0])
        print(f'usage: {program} [NAME:=OTHER_NAME...] [_PARAMETER:=VALUE...]\n\n'
              f'{documentation.strip()}')
        sys.exit(0)


def parameters(documentation):
    """Return the names of a node's parameters, in the order of its documentation."""
    _, _, text = documentation.partition('Parameters:')
    return [name for names in PARAMETER.findall(text) for name in names.split(', ')]


def warn_of_unknown(documentation):
    """Warn of arguments and of private parameters that the node does not know."""
    arguments = rospy.myargv()[1:]
    if arguments:
        rospy.logwarn(f'ignored: {", ".join(map(repr, arguments))}; --help tells what this node '
                      'understands')
    known = parameters(documentation)
    unknown = [name for name in _private_parameters() if name not in known]
    if unknown:
        rospy.logwarn(f'unknown: {", ".join(unknown)}; the parameters of this node are '
                      f'{", ".join(known) or "none"}')
    for name in unknown:
        forget_argument(name)


def _private_parameters():
    """Return the names of what is set in the node's namespace, but not below that."""
    values = rospy.get_param(rospy.get_name(), {})
    if not isinstance(values, dict):
        return []
    return sorted(f'~{name}' for name, value in values.items() if not isinstance(value, dict))
