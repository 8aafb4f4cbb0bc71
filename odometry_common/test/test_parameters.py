"""What a node says about a parameter that it cannot run with."""

import pytest
from odometry_common.node_help import check_command_line
from odometry_common.parameters import Parameter, ParameterError, Parameters, StartError, as_number

TABLE = Parameters(
    Parameter('~speed', 0.1, 'how fast', 'm/s', 'above 0'),
    Parameter('~slow', 0.01, 'slower', '', 'below ~speed'),
    Parameter('~step', 0.5, 'how far', 'm', 'from 0'),
    Parameter('~target', 90.0, 'where to', 'degrees'),
    Parameter('~robots', 1, 'how many', '', 'from 1 to 9'),
    Parameter('~gui', False, 'a window'),
    Parameter('~world', '', 'a file'),
    Parameter('~source', 'a', 'which', '', 'a or b'))


def test_defaults_and_values_are_of_the_type_of_the_default():
    """Numbers may be written in several ways; parameters are read by their names without ~."""
    values = vars(TABLE.read({'speed': 1, 'robots': 2.0, 'step': '1e-1'}, world='x'))
    assert values == {'speed': 1.0, 'slow': 0.01, 'step': 0.1, 'target': 90.0, 'robots': 2,
                      'gui': False, 'world': 'x', 'source': 'a'}
    assert [type(values[name]) for name in ('speed', 'robots')] == [float, int]
    # Bounds are allowed, except by "above" and "below".
    assert TABLE.read({'step': 0, 'robots': 9}).robots == 9


@pytest.mark.parametrize('name, value, allowed', [
    ('speed', 'fast', 'a number above 0 m/s'), ('slow', 0.2, 'a number below ~speed (0.1)'),
    ('step', -1e-9, 'a number from 0 m'), ('target', float('nan'), 'a finite number of degrees'),
    ('robots', 10, 'a whole number from 1 to 9'), ('gui', 1, 'true or false'), ('world', 1, 'a string'),
    ('source', 'c', 'a or b')])
def test_the_line_names_the_parameter_its_value_and_what_is_allowed(name, value, allowed):
    """A string is quoted, so that '1' and 1 can be told apart."""
    with pytest.raises(ParameterError) as refusal:
        TABLE.read({name: value})
    assert str(refusal.value) == f'parameter ~{name} is {value!r}, but must be {allowed}'
    assert refusal.value.name == f'~{name}'


@pytest.mark.parametrize('argument', [
    '_speed:=-0.2', '_speed:=2147483647', '_speed:=-2147483648', '_list:=[1, 2.0, text]', '_map:={a: 1}',
    '__name:=[1', 'speed:=/robot_1/speed'])
def test_what_ros_can_store_and_what_is_no_parameter_is_accepted(argument, monkeypatch):
    monkeypatch.setattr('sys.argv', ['node.py', argument])
    check_command_line(TABLE)


@pytest.mark.parametrize('argument', ['_speed', 'speed:=1', 'speed:=True'])
def test_what_looks_like_a_parameter_is_refused(argument, monkeypatch):
    monkeypatch.setattr('sys.argv', ['node.py', argument])
    with pytest.raises(StartError, match=f"^'{argument}' is no parameter: write _NAME:=VALUE"):
        check_command_line(TABLE)


@pytest.mark.parametrize('argument', [
    '_speed:=', '_speed:=2147483648', '_speed:=-2147483649', '_speed:=[1', '_speed:={1: 2}',
    '_speed:=2020-01-01', '_speed:=2020-13-45', '_speed:=[~]', f'_speed:={"[" * 1000}'])
def test_what_ros_cannot_store_is_refused_in_one_line(argument, monkeypatch):
    """Where rospy would answer with a traceback; the program's own name is no argument."""
    monkeypatch.setattr('sys.argv', ['_kp:=[', '_kp:=0.5', argument, '_rate:='])
    with pytest.raises(ParameterError) as refusal:
        check_command_line(TABLE)
    line, = str(refusal.value).splitlines()
    assert line.startswith(f'parameter ~speed is {argument.partition(":=")[2]!r}, but must be')


@pytest.mark.parametrize('value, number', [
    ('1e4', 1e4), ('-.5E-1', -0.05), ('+2E3', 2000.0), ('5', None), ('1e4\n', None),
    ('\u0661e4', None), ('1e999', None), (10**400, None), (True, None)])
def test_a_number_is_one_though_yaml_takes_it_for_a_string(value, number):
    assert as_number(value) == number
