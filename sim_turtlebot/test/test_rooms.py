"""Which of the simulator's rooms know each other: ROS on top of the robots on top of the physics."""

import re

import pytest
from odometry_tests.scripts import ROOT

PACKAGE = ROOT / 'sim_turtlebot/src/sim_turtlebot'
IMPORT = re.compile(r'^ *(?:from|import) (?:sim_turtlebot\.)?(\w+)', re.MULTILINE)
OTHERS = {path.stem for path in PACKAGE.iterdir()} | {'rospy', 'rosgraph', 'tf', 'tf2_ros'}
MAY_IMPORT = {'physics': {'physics', 'geometry', 'kobuki'}, 'robot': {'robot', 'geometry', 'kobuki'},
              'lockstep': {'lockstep', 'rospy', 'rosgraph'}}


@pytest.mark.parametrize('room', MAY_IMPORT)
def test_nothing_imports_upwards(room):
    """Only lockstep, which looks at the graph, has ROS."""
    text = ''.join(path.read_text() for path in (PACKAGE / room).glob('*.py'))
    assert OTHERS & set(IMPORT.findall(text)) <= MAY_IMPORT[room]
