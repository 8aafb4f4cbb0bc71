"""Every parameter of every node: what it cannot be is refused in one line, and nothing moves.

One table lists the parameters with their kind and range; the bad values follow from it, and a
test compares it with the nodes' own documentation, so that no parameter is left out.
"""

import re
from typing import NamedTuple

import pytest
import rospy
import yaml
from odometry_common.parameters import ParameterError, check_command_line
from odometry_common.usage import parameters
from odometry_tests.forked import run_script
from odometry_tests.scripts import ROOT, load_script
from sim_turtlebot.settings import read_settings

reference = load_script('test/tools/reference.py')
EXIT_BAD_PARAMETER = 2
# What the line that refuses a value says beside the range: the unit, what 0 does.
BESIDE_THE_RANGE = re.compile(
    r'^(a (?=finite)|a (speed|gain) in \S+ |a (whole )?number (of metres )?|a text|true or false)'
    r'| number of degrees$| \([^)]*\)|, \S+ Hz$| (m|s|Hz|rad/s|rad|degrees)\b')
NOT_NUMBERS = ['abc', "''", '[1, 2]', '{a: 1}', 'true', '.nan', 'nan', '.inf', '-.inf',
               '99999999999', '', '[', '2026-01-01']
NOT_FLAGS = ['abc', "''", '[true]', '{a: true}', '1', '0.5', '.nan', '']
NOT_TEXTS = ['1', '1.5', 'true', '[a]', '{a: b}', '']


class Parameter(NamedTuple):
    """A parameter and what it must refuse."""

    script: str
    name: str
    refused: list

    @property
    def node(self):
        """The name by which the test starts the node."""
        return f'{self.script.split("/")[-1][:-3]}_{self.name}'


DETECTOR = 'odom_movement_detector/src/odom_movement_detector.py'
MOVER = 'test_movement/src/test_movement.py'
ROTATOR = 'rotate_robot/script/rotate.py'
SIMULATOR = 'sim_turtlebot/script/sim_turtlebot_node.py'
VIEWER = 'robot_view/script/view.py'
READERS = {
    DETECTOR: lambda: load_script(DETECTOR).MovementDetector(),
    MOVER: lambda: load_script(MOVER).TestMovement(),
    ROTATOR: lambda: load_script(ROTATOR).RotateRobot(),
    SIMULATOR: read_settings,
}

TABLE = [
    Parameter(DETECTOR, 'min_step', [*NOT_NUMBERS, '-1']),
    Parameter(DETECTOR, 'max_speed', [*NOT_NUMBERS, '-0.1']),
    Parameter(MOVER, 'distance', [*NOT_NUMBERS, '0', '-1']),
    Parameter(MOVER, 'speed', [*NOT_NUMBERS, '0']),
    Parameter(MOVER, 'relative', NOT_FLAGS),
    Parameter(MOVER, 'exit_when_done', NOT_FLAGS),
    Parameter(MOVER, 'timeout', [*NOT_NUMBERS, '-1', '1e6']),
    Parameter(ROTATOR, 'target', NOT_NUMBERS),
    Parameter(ROTATOR, 'kp', [*NOT_NUMBERS, '0', '-0.5']),
    Parameter(ROTATOR, 'rate', [*NOT_NUMBERS, '0', '-10', '1e6']),
    Parameter(ROTATOR, 'max_angular_speed', [*NOT_NUMBERS, '0', '-1']),
    Parameter(ROTATOR, 'tolerance', [*NOT_NUMBERS, '-1', '180']),
    Parameter(ROTATOR, 'timeout', [*NOT_NUMBERS, '-1', '1e6']),
    Parameter(SIMULATOR, 'gui', NOT_FLAGS),
    Parameter(SIMULATOR, 'world', NOT_TEXTS),
    Parameter(SIMULATOR, 'robots', [*NOT_NUMBERS, '0', '-1', '1.5', '100000']),
    Parameter(SIMULATOR, 'x', [*NOT_NUMBERS, '1e5']),
    Parameter(SIMULATOR, 'y', [*NOT_NUMBERS, '-1e5']),
    Parameter(SIMULATOR, 'yaw', [*NOT_NUMBERS, '360']),
    Parameter(SIMULATOR, 'odom_rate', [*NOT_NUMBERS, '0', '-20', '1e5']),
    Parameter(SIMULATOR, 'clock_rate', [*NOT_NUMBERS, '-1', '10', '2000']),
    Parameter(SIMULATOR, 'odometry_source', [*NOT_TEXTS, 'gps', "''"]),
    Parameter(SIMULATOR, 'gyro', NOT_FLAGS),
    Parameter(SIMULATOR, 'wheel_slip', [*NOT_NUMBERS, '-0.1', '1']),
    Parameter(SIMULATOR, 'wheel_noise', [*NOT_NUMBERS, '-0.1', '10']),
    Parameter(SIMULATOR, 'gyro_noise', [*NOT_NUMBERS, '-0.1', '10']),
    Parameter(SIMULATOR, 'gyro_drift', [*NOT_NUMBERS, '-1.1', '10']),
    Parameter(SIMULATOR, 'scan', NOT_FLAGS),
    Parameter(SIMULATOR, 'scan_rate', [*NOT_NUMBERS, '0', '-1', '21']),
    Parameter(SIMULATOR, 'scan_beams', [*NOT_NUMBERS, '1', '-1', '0.5', '10001']),
    Parameter(SIMULATOR, 'scan_fov', [*NOT_NUMBERS, '0', '-1', '6.3', '360']),
    Parameter(SIMULATOR, 'scan_range_min', [*NOT_NUMBERS, '-0.1', '101']),
    Parameter(SIMULATOR, 'scan_range_max', [*NOT_NUMBERS, '0', '0.45', '1e4']),
    Parameter(SIMULATOR, 'scan_noise', [*NOT_NUMBERS, '-0.1', '10']),
    Parameter(SIMULATOR, 'seed', [*NOT_NUMBERS, '0.5', '1e12']),
    Parameter(SIMULATOR, 'cmd_vel_timeout', [*NOT_NUMBERS, '-1', '1e6']),
    Parameter(SIMULATOR, 'real_time_factor', [*NOT_NUMBERS, '-1', '1e-6', '2']),
    Parameter(SIMULATOR, 'lockstep', [*NOT_FLAGS, 'true']),
    Parameter(SIMULATOR, 'paused', NOT_FLAGS),
]
if (ROOT / VIEWER).exists():  # the package is optional
    from robot_view.address import read_address

    READERS[VIEWER] = read_address
    TABLE += [
        Parameter(VIEWER, 'port', [*NOT_NUMBERS, '0', '70000', '80.5']),
        Parameter(VIEWER, 'host', [*NOT_TEXTS, 'no such host', '192.0.2.1']),
        Parameter(VIEWER, 'allowed_hosts', [*NOT_TEXTS, '*', 'http://lab', 'lab/page', 'lab:0',
                                            'lab:', 'me@lab', '"::1"', 'lab, -x', 'good bad!']),
    ]


def complaint(parameter, text):
    """Return what the node says of _NAME:=TEXT; None if it takes it."""
    try:
        check_command_line([f'_{parameter.name}:={text}'])
        rospy.set_param(f'~{parameter.name}', yaml.safe_load(text))
        READERS[parameter.script]()
    except ParameterError as error:
        return str(error)
    finally:
        if rospy.has_param(f'~{parameter.name}'):
            rospy.delete_param(f'~{parameter.name}')
    return None


@pytest.mark.parametrize('parameter', TABLE, ids=lambda row: row.node)
def test_each_bad_value_is_refused_by_name(master, parameter):
    """All values of the table, against the node's own reading code and a real master."""
    for text in parameter.refused:
        said = complaint(parameter, text)
        assert said, f'{parameter.name}:={text} was taken'
        assert said.startswith(f'parameter ~{parameter.name} is ') and 'must be' in said
        assert '\n' not in said


def assert_refused(ended, *words):
    """Assert that a node has ended with status 2 and one line with all the words in it."""
    assert ended.status == EXIT_BAD_PARAMETER, ended
    assert len(ended.stderr.splitlines()) == 1, ended
    for word in words:
        assert word in ended.stderr


@pytest.mark.parametrize('parameter', TABLE, ids=lambda row: row.node)
def test_a_node_with_a_bad_value_ends_with_one_line_and_status_2(master, parameter):
    """The whole node, for one value of each parameter."""
    ended = run_script(parameter.script, f'__name:={parameter.node}',
                       f'_{parameter.name}:={parameter.refused[-1]}')
    assert_refused(ended, f'parameter ~{parameter.name} is ')
    left_behind = f'/{parameter.node}/{parameter.name}'
    assert not rospy.has_param(left_behind), 'the next run would be refused too'


def test_every_node_with_parameters_is_in_the_table():
    """A new node too."""
    scripts = {str(path.relative_to(ROOT)) for folder in ('src', 'script', 'scripts')
               for path in ROOT.glob(f'*/{folder}/*.py') if path.parent.parent.name != 'test'}
    assert {script for script in scripts
            if parameters(load_script(script).__doc__ or '')} == set(READERS)


@pytest.mark.parametrize('script', READERS)
def test_the_table_has_every_parameter(script):
    """A new parameter is in its node's documentation, and so has to be here."""
    known = parameters(load_script(script).__doc__)
    assert sorted(known) == sorted(f'~{row.name}' for row in TABLE if row.script == script)


@pytest.mark.parametrize('parameter', TABLE, ids=lambda row: row.node)
def test_default_and_range_in_the_documentation_are_those_of_the_code(parameter, monkeypatch):
    """What --help prints, and docs/reference.md has, against what the node reads and refuses."""
    defaults, name = {}, f'~{parameter.name}'

    def get_param(asked, default):
        defaults[asked] = default
        return object() if asked == name else default

    monkeypatch.setattr(rospy, 'get_param', get_param)
    with pytest.raises(ParameterError) as refusal:
        READERS[parameter.script]()
    said, = [entry for entry in reference.entries(load_script(parameter.script).__doc__)
             if entry.section == reference.PARAMETERS and name in entry.names.split(', ')]
    assert yaml.safe_load(said.default.split()[0]) == defaults[name]
    assert said.type == type(defaults[name]).__name__
    assert said.range == BESIDE_THE_RANGE.sub('', str(refusal.value).partition('but must be ')[2])


def test_a_world_that_cannot_be_used_ends_the_simulator(master, tmp_path):
    """The line names the file and the reason; test_odd_worlds tries many of them."""
    (tmp_path / 'x.urdf').mkdir()
    ended = run_script(SIMULATOR, f'_world:={tmp_path}/x.urdf')
    assert_refused(ended, f'parameter ~world is \'{tmp_path}/x.urdf\'', 'is a folder')


@pytest.mark.parametrize('display', ['', ':987'])
def test_a_window_without_a_screen_is_refused(master, display):
    """Most machines that run this have none."""
    ended = run_script(SIMULATOR, '_gui:=true', env={'DISPLAY': display})
    assert_refused(ended, '~gui', 'DISPLAY')
