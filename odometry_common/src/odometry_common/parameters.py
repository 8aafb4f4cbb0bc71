"""A node's parameters: declared in one table, and checked before the node starts."""

import math
import operator
import re
import textwrap
from types import SimpleNamespace
from typing import Any, NamedTuple

# YAML 1.1 reads 1e4 as a string; a number needs a point and a sign, 1.0e+4.
WITH_EXPONENT = re.compile(r'[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+')
HELP_WIDTH = 100
# The words of a range, and how a value compares with the number after each.
COMPARISONS = {'from': operator.ge, 'above': operator.gt, 'to': operator.le, 'below': operator.lt,
               'than': operator.ne}
BOUND = re.compile(rf'({"|".join(COMPARISONS)}) (?:~(\w+)|(-?[\d.]+)( pi)?)')


class StartError(Exception):
    """The node cannot start; the message is one line for the user."""


class ParameterError(StartError):
    """A parameter has a value that the node cannot use."""

    def __init__(self, name, value, allowed):
        self.name = name
        super().__init__(f'parameter {name} is {value!r}, but must be {allowed}')


class Parameter(NamedTuple):
    """A parameter; it has the type of its default: float, int, bool or str."""

    name: str  # such as ~speed
    default: Any
    meaning: str
    unit: str = ''
    # The values that are allowed, in words: "0 or from 0.1 to below ~speed", where ~speed is read
    # before it, or "world or encoder"; empty: any
    range: str = ''

    @property
    def type(self):
        """Its type's name."""
        return type(self.default).__name__

    @property
    def default_text(self):
        """The default with its unit, as YAML."""
        if isinstance(self.default, bool):
            return str(self.default).lower()
        if isinstance(self.default, str):
            return self.default or "''"
        return f'{self.default:g} {self.unit}'.strip()

    def check(self, given, earlier=None):
        """Convert a value of the parameter server to this type.

        :param earlier: namespace of the parameters read before this one
        :raises ParameterError: if it is of another type, not finite or out of range
        """
        kind = type(self.default)
        is_number = kind in (float, int)
        value = as_number(given) if is_number else given
        usable = (value is not None and value == kind(value) if is_number
                  else isinstance(value, kind))
        if not usable or not self._is_in_range(value, earlier):
            raise ParameterError(self.name, given, self._allowed(earlier))
        return kind(value)

    def _is_in_range(self, value, earlier):
        if isinstance(value, str):
            return not self.range or value in self.range.split(' or ')
        if value == 0 and self.range.startswith('0 or '):
            return True
        for word, name, number, pi in BOUND.findall(self.range):
            bound = getattr(earlier, name) if name else float(number) * (math.pi if pi else 1)
            if not COMPARISONS[word](value, bound):
                return False
        return True

    def _allowed(self, earlier):
        text = re.sub(r'~(\w+)', lambda found: f'{found[0]} ({getattr(earlier, found[1]):g})',
                      self.range)
        if isinstance(self.default, bool):
            return 'true or false'
        if isinstance(self.default, str):
            return text or 'a string'
        if not text:
            return f'a finite number of {self.unit}'
        kind = 'a whole number' if isinstance(self.default, int) else 'a number'
        return f'{kind} {text} {self.unit}'.rstrip()


class Parameters:
    """The table of a node's parameters, each a Parameter, in the order in which they are read."""

    def __init__(self, *rows):
        self.rows = rows

    @property
    def names(self):
        """The names, such as ~speed."""
        return [row.name for row in self.rows]

    @property
    def help(self):
        """The part of --help that describes them; '' if there are none."""
        return '\n'.join(['Parameters:', *map(_help_of, self.rows)]) if self.rows else ''

    def read(self, source=None, **defaults):
        """Return a namespace with all values, by their names without ~.

        :param source: dictionary of given values by these names; None: the ROS parameter server
        :param defaults: replace defaults of the table
        :raises ParameterError: for the first value that the node cannot use
        """
        values = SimpleNamespace()
        source = _on_server(self.names) if source is None else source
        for row in self.rows:
            name = row.name.lstrip('~/')
            given = source.get(name, defaults.get(name, row.default))
            setattr(values, name, row.check(given, values))
        return values


def _on_server(names):
    """Return the parameter server's values; the private ones by one call, which takes 0.4 ms."""
    import rospy  # here, since the arithmetic that declares parameters needs no ROS
    own = rospy.get_param(rospy.get_name(), {})
    # A global name, or one that is remapped.
    elsewhere = {name.lstrip('~/'): rospy.get_param(name) for name in names
                 if rospy.resolve_name(name) != f'{rospy.get_name()}/{name.lstrip("~/")}'
                 and rospy.has_param(name)}
    return {**(own if isinstance(own, dict) else {}), **elsewhere}


def _help_of(row):
    facts = ', '.join(filter(None, [row.type, row.default_text, row.range]))
    return textwrap.fill(f'{row.name} ({facts}): {row.meaning}', HELP_WIDTH,
                         initial_indent=' ' * 4, subsequent_indent=' ' * 8)


def as_number(value):
    """Return a value of the parameter server as a float; None if it is not a finite number."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    is_written_as_one = isinstance(value, str) and WITH_EXPONENT.fullmatch(value)
    try:
        number = float(value) if is_number or is_written_as_one else math.nan
    except OverflowError:  # an int of more than 308 digits
        return None
    return number if math.isfinite(number) else None
