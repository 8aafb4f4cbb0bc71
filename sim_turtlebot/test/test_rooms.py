"""Which of the simulator's rooms know each other: ROS on top of the robots on top of the physics."""

import ast

import pytest
from odometry_tests.scripts import ROOT

PACKAGE = ROOT / 'sim_turtlebot' / 'src' / 'sim_turtlebot'
ROS = {'rospy', 'rosgraph', 'tf', 'tf2_ros'}
NUMBERS = {'geometry', 'kobuki'}
MAY_IMPORT = {'physics': {'physics', *NUMBERS}, 'robot': {'robot', *NUMBERS}, 'lockstep': {'lockstep'}}


@pytest.mark.parametrize('room', MAY_IMPORT)
def test_nothing_imports_upwards(room):
    """Only lockstep, which looks at the graph, has ROS."""
    imported = set()
    for path in (PACKAGE / room).glob('*.py'):
        for node in ast.walk(ast.parse(path.read_text(encoding='utf-8'))):
            names = ([node.module or ''] if isinstance(node, ast.ImportFrom) else
                     [alias.name for alias in node.names] if isinstance(node, ast.Import) else [])
            imported.update(names)
    ours = {name.split('.')[1] for name in imported if name.startswith('sim_turtlebot.')}
    assert ours <= MAY_IMPORT[room]
    assert room == 'lockstep' or not ROS & {name.split('.')[0] for name in imported}
