"""Private parameters that are checked before a node does anything."""

import contextlib
import math
import re
import sys
import xmlrpc.client

import rospy
import yaml

# YAML 1.1 takes 1e4 for a text: it wants a point and a sign in it, 1.0e+4.
WITH_EXPONENT = re.compile(r'[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+')


class StartError(Exception):
    """The node cannot start; the message is one line for the user."""


class ParameterError(StartError):
    """A parameter the node cannot run with."""

    def __init__(self, name, value, allowed):
        """Word the line from the name, the value that was given and what is allowed."""
        self.name = name
        super().__init__(f'parameter {name} is {value!r}, but must be {allowed}')


def _from_server(name, default):
    return rospy.get_param(name, default)


_read = _from_server


@contextlib.contextmanager
def read_from(values):
    """Read parameters from a dictionary of their names without ~, instead of from a ROS master.

    :return: a set, to which each name is added that is asked for
    """
    global _read
    asked = set()

    def read(name, default):
        name = name.lstrip('~')
        asked.add(name)
        return values.get(name, default)

    _read = read
    try:
        yield asked
    finally:
        _read = _from_server


def get_number(name, default, accepts=math.isfinite, allowed='a finite number'):
    """Read a number.

    :param name: parameter name, such as ``~speed``
    :param accepts: takes a finite float; returns whether it is in range
    :param allowed: the range in words, for the user
    :return: the value as a float
    :raises ParameterError: if it is not a finite number, or out of range
    """
    given = _read(name, default)
    value = as_number(given)
    if value is None or not math.isfinite(value) or not accepts(value):
        raise ParameterError(name, given, allowed)
    return value


def as_number(value):
    """Return a value of the parameter server as a float; None if it is not a number."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    is_written_as_one = isinstance(value, str) and WITH_EXPONENT.fullmatch(value)
    return float(value) if is_number or is_written_as_one else None


def get_whole(name, default, lowest, highest):
    """Read a whole number; raise ParameterError if the value is another one, or out of range."""
    return int(get_number(name, default, lambda v: v == int(v) and lowest <= v <= highest,
                          f'a whole number from {lowest} to {highest}'))


def get_flag(name, default):
    """Read a boolean; raise ParameterError if the value is of another type."""
    return _get(name, default, lambda value: isinstance(value, bool), 'true or false')


def get_choice(name, default, choices):
    """Read one of a few strings; raise ParameterError if the value is another one."""
    return _get(name, default, lambda value: value in choices, ' or '.join(choices))


def get_text(name, default):
    """Read a string; raise ParameterError if the value is of another type."""
    return _get(name, default, lambda value: isinstance(value, str), 'a text')


def _get(name, default, accepts, allowed):
    value = _read(name, default)
    if not accepts(value):
        raise ParameterError(name, value, allowed)
    return value


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
                f'~{name[1:]}', text, 'a value that ROS can store: a text, a number with at '
                'most 32 bits or a decimal point, true or false, or a list of them') from None


def forget_argument(name):
    """Take back a parameter (such as ~speed) that the command line set, or the next run gets it.

    What `_name:=value` once set stays on the parameter server.
    """
    given = any(argument.startswith(f'_{name[1:]}:=') for argument in sys.argv[1:])
    if given and rospy.core.is_initialized() and rospy.has_param(name):
        rospy.delete_param(name)
