"""Which of the simulator's rooms know each other: ROS on top of the robots on top of the physics."""

import re

import pytest
from odometry_tests.scripts import ROOT

PACKAGE = ROOT / 'sim_turtlebot' / 'src' / 'sim_turtlebot'
IMPORT = re.compile(r'^ *(?:from|import) ([\w.]+)', re.MULTILINE)
ROS = {'rospy', 'rosgraph', 'tf', 'tf2_ros'}
NUMBERS = {'geometry', 'kobuki'}
MAY_IMPORT = {'physics': {'physics', *NUMBERS}, 'robot': {'robot', *NUMBERS}, 'lockstep': {'lockstep'}}


@pytest.mark.parametrize('room', MAY_IMPORT)
def test_nothing_imports_upwards(room):
    """Only lockstep, which looks at the graph, has ROS."""
    text = ''.join(path.read_text() for path in (PACKAGE / room).glob('*.py'))
    imported = IMPORT.findall(text)
    assert {name.split('.')[1] for name in imported if name.startswith('sim_turtlebot.')} <= MAY_IMPORT[room]
    assert room == 'lockstep' or not ROS & {name.split('.')[0] for name in imported}
