"""What the robot does with commands: limits, stops, resets, and being pushed."""

import math

import pytest
from odometry_tests.simulation import Simulation


def speeds(simulation):
    truth = simulation.robot.ground_truth
    return truth.linear[0], truth.angular[2]


@pytest.mark.parametrize('command, expected', [
    ((0.8, 0.0), (0.7, 0.0)), ((-1e300, 0.0), (-0.7, 0.0)), ((0.0, 4.0), (0.0, math.pi)),
    ((0.0, -1e300), (0.0, -math.pi)), ((100.0, -100.0), (0.7, -math.pi)),
    ((0.7, 0.0), (0.7, 0.0)), ((0.69, -3.1), (0.69, -3.1))])
def test_a_twist_that_it_cannot_do_is_clamped(command, expected):
    """0.7 m/s and half a turn per second, each on its own."""
    simulation = Simulation()
    simulation.drive(*command, 2.0)
    assert speeds(simulation) == pytest.approx(expected, rel=0.01, abs=0.01)


@pytest.mark.parametrize('command', [
    (math.nan, 0.0), (0.0, math.nan), (math.inf, 0.0), (0.1, -math.inf)])
def test_a_command_that_is_not_finite_is_refused_and_stops_it(command):
    simulation = Simulation()
    simulation.drive(0.3, 0.5, 1.0)
    with pytest.raises(ValueError, match='is not finite'):
        simulation.command(*command)
    simulation.run(1.0)
    assert simulation.robot.resting
    simulation.drive(0.3, 0.0, 1.0)
    assert speeds(simulation) == pytest.approx((0.3, 0.0), abs=0.01)


@pytest.mark.parametrize('velocity', [(0.3, 0.0), (0.0, 1.0)])
def test_it_stops_when_commands_cease(velocity):
    simulation = Simulation(cmd_vel_timeout=0.6)
    for _ in range(10):
        simulation.drive(*velocity, 0.5)
        assert speeds(simulation) == pytest.approx(velocity, abs=0.01)
    simulation.run(0.1)
    assert speeds(simulation) == pytest.approx(velocity, abs=0.01)
    assert not simulation.robot.timed_out
    simulation.run(0.3)
    assert speeds(simulation) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert simulation.robot.timed_out
    simulation.drive(*velocity, 0.5)
    assert speeds(simulation) == pytest.approx(velocity, abs=0.01)


def test_a_timeout_below_a_step_of_time_is_no_lack_of_one():
    simulation = Simulation(cmd_vel_timeout=0.001)
    simulation.drive(0.3, 0.0, 1.0)
    assert speeds(simulation) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert simulation.robot.ground_truth.position[0] < 0.01


def test_a_standing_robot_that_is_pushed_is_moved_and_knows_it():
    """Until the other one stops; then it stands again, where it has been pushed to."""
    simulation = Simulation((0, 0, 0), (-0.6, 0, 0))
    assert len(set(simulation.run(1.0).odometry)) == 1
    simulation.command(0.2, 0.0, robot=1)
    simulation.run(3.0)
    assert simulation.robot.ground_truth.position[0] > 0.1
    assert simulation.robot.odometry.position == pytest.approx(
        simulation.robot.ground_truth.position, abs=1e-9)
    simulation.command(0.0, 0.0, robot=1)
    simulation.run(1.0)
    assert all(robot.resting for robot in simulation.robots)
    assert len(set(simulation.run(10.0).odometry)) == 1
