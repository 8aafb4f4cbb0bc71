"""Parameters that the command line of a node sets, as ``_name:=value``."""

import sys
import xmlrpc.client

import rospy
import yaml

from odometry_common.parameters import ParameterError


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
