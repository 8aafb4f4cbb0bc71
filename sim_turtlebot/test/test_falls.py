"""Robots that lie on their side."""

import math

import pytest
from odometry_common.geometry import about_z
from odometry_tests.simulation import Simulation
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


def run(simulation, falls, duration):
    """Simulate so many seconds; return what is noticed by a look at each odometry."""
    seen = []
    for _ in range(round(duration * simulation.timeline.odom_rate)):
        simulation.run(1 / simulation.timeline.odom_rate)
        seen += falls.look()
    return seen


def test_a_robot_that_drives_over_an_edge_is_reported_once(table):
    """And once more when it is back."""
    simulation = Simulation(world=table)
    falls = Falls(simulation.robots)
    simulation.robot.set_pose((3.0, 0.0, 0.3), about_z(0.0))
    assert run(simulation, falls, 1.0) == []
    simulation.command(0.1, 0.0)
    (name, text), = run(simulation, falls, 8.0)
    assert name == 'the robot'
    assert text.startswith('the robot lies on its side at x 3.')
    assert text.endswith('~reset_simulation brings it back')
    simulation.reset()
    assert run(simulation, falls, 1.0) == [('the robot', '')]


def test_the_one_that_lies_is_named():
    """Of several."""
    simulation = Simulation((0, 0, 0), (0, 1, 0))
    falls = Falls(simulation.robots)
    simulation.robots[1].set_pose((-0.001, 1.234, 0.3), ON_ITS_SIDE)
    assert list(falls.look()) == [
        ('robot_2', 'robot_2 lies on its side at x 0, y 1.23; ~reset_simulation brings it back')]
    assert not list(falls.look())


def test_a_robot_that_leans_does_not_lie():
    """By half a right angle it may still come back."""
    simulation = Simulation()
    simulation.robot.set_pose((0.0, 0.0, 1.0), (math.sin(0.39), 0.0, 0.0, math.cos(0.39)))
    assert not list(Falls(simulation.robots).look())
