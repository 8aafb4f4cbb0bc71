"""Every parameter of every node: what it cannot be is refused in one line, and nothing moves."""

import math
import re

import pytest
from odometry_common.parameters import ParameterError
from odometry_tests import scripts
from odometry_tests.processes import assert_refused, run_script
from odometry_tests.scripts import load_script
from sim_turtlebot.settings import read_settings

NOT_NUMBERS = ['abc', '', [1, 2], {'a': 1}, True, float('nan'), 'nan', float('inf'), '2026-01-01']
WRONG_TYPE = {float: NOT_NUMBERS, int: [*NOT_NUMBERS, 1.5], bool: ['abc', '', [True], 1, 0.5],
              str: [1, 1.5, True, ['a'], {'a': 'b'}]}
SCRIPTS = {path.name: load_script(path) for path in scripts.SCRIPTS}
TABLES = {name: script.PARAMETERS for name, script in SCRIPTS.items()
          if hasattr(script, 'PARAMETERS')}
ROWS = [(script, row) for script, table in TABLES.items() for row in table.rows]
READERS = {'sim_turtlebot_node.py': read_settings}
BOUND = re.compile(r'(from|above|up to|to below|to) (-?[\d.]+)( pi)?')
# What a range's text has no number for.
FURTHER = {
    'speed': [0], 'clock_rate': [10], 'scan_range_max': [0.45], 'odometry_source': ['gps', ''],
    'real_time_factor': [2.0], 'lockstep': [True], 'host': ['no such host', '192.0.2.1'],
    'allowed_hosts': ['*', 'http://lab', 'lab/page', 'lab:0', 'lab:70000', 'lab:', 'me@lab', '::1', 'lab, -x', 'good bad!']}

if 'view.py' in TABLES:  # the package is optional
    from robot_view.address import read_address

    READERS['view.py'] = read_address


def out_of_range(row):
    """Return numbers outside of a parameter's range: beyond each bound in its text, or at one that is left out."""
    for word, number, pi in BOUND.findall(row.range):
        bound = float(number) * (math.pi if pi else 1)
        yield bound + {'from': -1, 'above': 0, 'to below': 0}.get(word, 1)
    yield from FURTHER.get(row.name[1:], [])


@pytest.mark.parametrize('script, row', ROWS, ids=lambda value: getattr(value, 'name', value))
def test_each_bad_value_is_refused_by_name(script, row):
    name, read = row.name[1:], READERS.get(script, TABLES[script].read)
    bad = [*out_of_range(row)]
    assert bad or not row.range, 'the table above lacks it'
    for value in [*WRONG_TYPE[type(row.default)], *bad]:
        with pytest.raises(ParameterError) as refusal:
            read({name: value})
        assert str(refusal.value).startswith(f'parameter {row.name} is {value!r}, but must be ')


@pytest.mark.parametrize('name, value', [('odom_rate', 0.1), ('odom_rate', 1000)])
def test_a_value_is_accepted_beside_the_defaults_that_a_launch_file_sets(name, value):
    defaults = {row.name[1:]: row.default for row in TABLES['sim_turtlebot_node.py'].rows}
    settings = read_settings({**defaults, 'use_sim_time': True, name: value})
    assert settings.scan_rate <= settings.odom_rate


@pytest.mark.parametrize('script, text', [(script, 'abc') for script in TABLES] + [('rotate.py', '')])
def test_a_node_with_a_bad_value_ends_with_one_line_and_status_2(master, script, text):
    """Whether the node refuses the value, or ROS could not store it."""
    row = next(row for row in TABLES[script].rows if row.type != 'str')
    # What is set stays on the master: each node has a name of its own.
    ended = run_script(SCRIPTS[script].__file__, f'__name:={script.partition(".")[0]}_refused',
                       f'_{row.name[1:]}:={text}')
    assert_refused(ended, f'parameter {row.name} is {text!r}, but must be ')


@pytest.mark.parametrize('by_roslaunch', [[], ['__log:=']])
def test_a_world_that_cannot_be_used_ends_the_simulator(master, tmp_path, by_roslaunch):
    """The line names the file and the reason; test_worlds tries many of them."""
    (tmp_path / 'x.urdf').mkdir()
    ended = run_script(SCRIPTS['sim_turtlebot_node.py'].__file__, f'_world:={tmp_path}/x.urdf', *by_roslaunch)
    assert_refused(ended, f'parameter ~world is \'{tmp_path}/x.urdf\'', 'is a folder')
    assert ('rosparam delete /' in ended.stderr) != bool(by_roslaunch), ended.stderr
