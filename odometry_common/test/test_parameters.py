"""What is said about a parameter that a node cannot run with."""

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.parameters import (
    ParameterError,
    as_number,
    check_command_line,
    get_flag,
    get_number,
    read_from,
)


@pytest.mark.parametrize('name, value, allowed, line', [
    ('~speed', 'fast', 'a finite number',
     "parameter ~speed is 'fast', but must be a finite number"),
    ('~max_speed', -1.0, 'a speed in m/s from 0',
     'parameter ~max_speed is -1.0, but must be a speed in m/s from 0'),
    ('~gui', 1, 'true or false', 'parameter ~gui is 1, but must be true or false'),
    ('~kp', float('nan'), 'above 0', 'parameter ~kp is nan, but must be above 0')])
def test_the_line_names_the_parameter_its_value_and_what_is_allowed(name, value, allowed, line):
    """A text is quoted, so that '1' and 1 can be told apart."""
    error = ParameterError(name, value, allowed)
    assert str(error) == line
    assert error.name == name


@given(st.text())
def test_the_line_is_one_line_whatever_the_value(value):
    """A line break in the value does not break it."""
    assert len(str(ParameterError('~speed', value, 'a number')).splitlines()) == 1


@pytest.mark.parametrize('argument', [
    '_speed:=0.2', '_speed:=-0.2', '_distance:=2', '_speed:=2147483647', '_speed:=-2147483648',
    '_relative:=true', '_world:=room.urdf', "_world:='2020-01-01'", '_list:=[1, 2.0, text]',
    '_map:={a: 1}', '_text:=größer'])
def test_what_ros_can_store_is_accepted(argument):
    """Whether it suits the node is for the node to say."""
    check_command_line([argument])


@pytest.mark.parametrize('argument', [
    '_speed:=', '_speed:=2147483648', '_speed:=-2147483649', '_speed:=[1', '_speed:={1: 2}',
    '_speed:=2020-01-01', '_speed:=null', '_speed:=[~]', '_speed:=%', '_speed:=2: 3: 4',
    '_speed:=!!python/none', f'_speed:={"[" * 5000}'])
def test_what_ros_cannot_store_is_refused_in_one_line(argument):
    """Where rospy would answer with a traceback."""
    with pytest.raises(ParameterError) as refusal:
        check_command_line([argument])
    line = str(refusal.value)
    assert line.startswith(f'parameter ~speed is {argument.partition(":=")[2]!r}, but must be')
    assert len(line.splitlines()) == 1


@pytest.mark.parametrize('argument', [
    '__name:=[1', '__ns:=', 'cmd_vel:=', '/odom:=/robot_1/odom', '_speed', '_speed=', '', ':='])
def test_what_is_no_private_parameter_is_none_of_its_business(argument):
    """Remappings, special names and plain arguments are left to rospy."""
    check_command_line([argument])


def test_one_bad_parameter_among_good_ones_is_found():
    """The first one is named."""
    with pytest.raises(ParameterError, match='~kp is'):
        check_command_line(['_speed:=0.2', '__name:=mover', '_kp:=[', '_rate:='])


def test_the_command_line_is_that_of_the_process(monkeypatch):
    """Unless another one is given; the program's own name is no argument."""
    monkeypatch.setattr('sys.argv', ['_speed:=[', '_kp:=0.5'])
    check_command_line()
    monkeypatch.setattr('sys.argv', ['rotate.py', '_kp:=['])
    with pytest.raises(ParameterError, match='~kp'):
        check_command_line()


@given(st.text())
def test_no_text_ends_in_another_error(text):
    """Whatever a user types after the :=, a node starts or says what is wrong."""
    try:
        check_command_line([f'_speed:={text}'])
    except ParameterError as error:
        assert error.name == '~speed'


@pytest.mark.parametrize('text, number', [
    ('1e4', 1e4), ('-1e-1', -0.1), ('+2E3', 2000.0), ('1.e2', 100.0), ('.5e1', 5.0), ('1.5e3', 1500.0),
    ('1.0e+4', 1e4), ('-0', 0.0), ('2', 2.0), ('0.1', 0.1)])
def test_a_number_is_one_however_it_is_written(text, number):
    """PyYAML, by which ROS reads the command line, takes some of them for a text."""
    assert as_number(yaml.safe_load(text)) == number


@pytest.mark.parametrize('value', [
    'abc', '', '5', '0.1', '1e', 'e4', '1e4m', ' 1e4', '1e4\n', '0x1e4', '1_0e4', '\u0661e4', 'nan', 'inf',
    '1e1e1', '.e1', True, False, None, [1.0], {}])
def test_what_is_written_otherwise_is_none(value):
    """A number in quotes is a text, as ever."""
    assert as_number(value) is None


def test_parameters_can_come_from_a_dictionary():
    """Without a master: by their names, with the same defaults, ranges and lines."""
    with read_from({'speed': 0.2, 'kp': 'fast'}) as asked:
        assert get_number('~speed', 0.1) == 0.2
        assert get_flag('~relative', False) is False
        with pytest.raises(ParameterError, match="parameter ~kp is 'fast', but must be a finite"):
            get_number('~kp', 0.5)
    assert asked == {'speed', 'relative', 'kp'}


def test_afterwards_they_come_from_the_master_again(monkeypatch):
    """Also after a bad one."""
    monkeypatch.setattr('rospy.get_param', lambda name, default: 0.3)
    with pytest.raises(ParameterError), read_from({'speed': 'fast'}):
        get_number('~speed', 0.1)
    assert get_number('~speed', 0.1) == 0.3
