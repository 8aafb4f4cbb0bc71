"""Robots that lie on their side, and how that is told beside other warnings."""

import math

import pytest
from odometry_common.geometry import about_z
from odometry_tests.simulation import Simulation
from sim_turtlebot.current_warnings import CurrentWarnings
from sim_turtlebot.falls import Falls

ON_ITS_SIDE = math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)
TABLE = """<robot name="table"><link name="top"><collision><origin xyz="3 0 0.15"/>
<geometry><box size="1 1 0.3"/></geometry></collision></link></robot>"""


@pytest.fixture
def table(tmp_path):
    """Return a world with a table, 0.3 m high, from x 2.5 to 3.5 m."""
    path = tmp_path / 'table.urdf'
    path.write_text(TABLE)
    return str(path)


def watched(*starts, **others):
    """Return a simulation, what watches its robots, and the list of what that reports."""
    simulation = Simulation(*starts, **others)
    reports = []
    return simulation, Falls(simulation.robots, lambda *report: reports.append(report)), reports


def run(simulation, falls, duration):
    """Simulate so many seconds, with a look at each odometry."""
    for _ in range(round(duration * simulation.timeline.odom_rate)):
        simulation.run(1 / simulation.timeline.odom_rate)
        falls.look()


def test_a_robot_that_drives_over_an_edge_is_reported_once(table):
    """And once more when it is back."""
    simulation, falls, reports = watched(world_file=table)
    simulation.robot.set_pose((3.0, 0.0, 0.3), about_z(0.0))
    run(simulation, falls, 1.0)
    assert reports == []
    simulation.command(0.1, 0.0)
    run(simulation, falls, 8.0)
    (name, text), = reports
    assert name == 'the robot'
    assert text.startswith('the robot lies on its side at x 3.')
    assert text.endswith('~reset_simulation brings it back')
    simulation.reset()
    run(simulation, falls, 1.0)
    assert reports[1:] == [('the robot', '')]


def test_the_one_that_lies_is_named():
    """Of several."""
    simulation, falls, reports = watched((0, 0, 0), (0, 1, 0))
    simulation.robots[1].set_pose((-0.001, 1.234, 0.3), ON_ITS_SIDE)
    falls.look()
    falls.look()
    assert reports == [
        ('robot_2', 'robot_2 lies on its side at x 0, y 1.23; ~reset_simulation brings it back')]


def test_a_robot_that_leans_does_not_lie():
    """By half a right angle it may still come back."""
    simulation, falls, reports = watched()
    simulation.robot.set_pose((0.0, 0.0, 1.0), (math.sin(0.39), 0.0, 0.0, math.cos(0.39)))
    falls.look()
    assert reports == []


def test_warnings_stand_side_by_side():
    """Each until its own cause is gone."""
    said = []
    warnings = CurrentWarnings(said.append)
    warnings.set('pace', 'too slow')
    warnings.set('robot_2', 'it lies')
    warnings.set('pace', '')
    warnings.set('robot_2', '')
    assert said == ['', 'too slow', 'too slow; it lies', 'it lies', '']


def test_a_cause_has_one_warning():
    """The latest."""
    said = []
    warnings = CurrentWarnings(said.append)
    warnings.set('robot_2', 'it lies here')
    warnings.set('robot_2', 'it lies there')
    assert said[-1] == 'it lies there'
