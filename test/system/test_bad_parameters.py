"""Every parameter of every node: what it cannot be is refused in one line, and nothing moves."""

import pytest
from odometry_common.parameters import ANY, ParameterError
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
# What only a range of its own refuses; each range refuses something that is far off.
OUT_OF_RANGE = {
    'tolerance': [180], 'yaw': [360], 'clock_rate': [10, 2000], 'cpu_budget': [3601], 'speed_ratio': [1.1],
    'wheel_slip': [1], 'scan_range_max': [0.45], 'real_time_factor': [1e-6, 2.0], 'lockstep': [True],
    'port': [70000], 'host': ['no such host', '192.0.2.1'],
    'allowed_hosts': ['http://lab', 'lab/page', 'lab:0', 'lab:70000', 'lab:', 'me@lab', '::1', 'lab, -x', 'good bad!']}


if 'view.py' in TABLES:  # the package is optional
    from robot_view.address import read_address

    READERS['view.py'] = read_address


def refusal_of(script, name, value):
    read = READERS.get(script, TABLES[script].read)
    try:
        read({name: value})
    except ParameterError as error:
        return str(error)
    return 'accepted'


@pytest.mark.parametrize('script, row', ROWS, ids=lambda value: getattr(value, 'name', value))
def test_each_bad_value_is_refused_by_name(script, row):
    name, far_off = row.name[1:], ['*'] if row.type == 'str' else [0, -1e12, 1e12]
    for value in [*WRONG_TYPE[type(row.default)], *OUT_OF_RANGE.get(name, [])]:
        assert refusal_of(script, name, value).startswith(f'parameter {row.name} is {value!r}, but must be ')
    assert row.range is ANY or any(refusal_of(script, name, value) != 'accepted' for value in far_off)


@pytest.mark.parametrize('script, text', [(script, 'abc') for script in TABLES] + [('rotate.py', '')])
def test_a_node_with_a_bad_value_ends_with_one_line_and_status_2(master, script, text):
    """Whether the node refuses the value, or ROS could not store it."""
    row = next(row for row in TABLES[script].rows if row.type != 'str')
    # What is set stays on the master: each node has a name of its own.
    ended = run_script(SCRIPTS[script].__file__, f'__name:={script.partition(".")[0]}_refused',
                       f'_{row.name[1:]}:={text}')
    assert_refused(ended, f'parameter {row.name} is {text!r}, but must be ')


def test_a_world_that_cannot_be_used_ends_the_simulator(master, tmp_path):
    """The line names the file and the reason; test_worlds tries many of them."""
    (tmp_path / 'x.urdf').mkdir()
    ended = run_script(SCRIPTS['sim_turtlebot_node.py'].__file__, f'_world:={tmp_path}/x.urdf')
    assert_refused(ended, f'parameter ~world is \'{tmp_path}/x.urdf\'', 'is a folder')
