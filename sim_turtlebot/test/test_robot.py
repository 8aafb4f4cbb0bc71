"""What the robot does with commands: limits, stops, and whom it obeys."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_tests.simulation import Simulation
from sim_turtlebot.robot.multiplexer import VelocityMux

TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
SECOND = 10**9  # ns
pauses = st.sampled_from([0, SECOND - 1, SECOND]) | st.integers(0, 2 * SECOND)  # ns


def speeds(simulation):
    truth = simulation.robot.ground_truth
    return truth.linear[0], truth.angular[2]


@pytest.mark.parametrize('command, expected', [
    ((-1e300, 0.0), (-0.7, 0.0)), ((0.8, -100.0), (0.7, -math.pi)),
    ((0.69, -3.1), (0.69, -3.1))])
def test_a_twist_that_it_cannot_do_is_clamped(command, expected):
    """0.7 m/s and half a turn per second, each on its own."""
    simulation = Simulation()
    simulation.drive(*command, 2.0)
    assert speeds(simulation) == pytest.approx(expected, rel=0.01, abs=0.01)


def test_a_timeout_below_a_step_of_time_is_no_lack_of_one():
    simulation = Simulation(cmd_vel_timeout=0.001)
    simulation.drive(0.3, 0.0, 1.0)
    assert speeds(simulation) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert simulation.robot.ground_truth.position[0] < 0.01


@given(st.lists(st.tuples(st.sampled_from([TELEOP, NAVI]), pauses), max_size=50))
def test_teleop_is_always_obeyed_and_navi_when_teleop_is_silent(commands):
    """Against the rule itself, for the two inputs of a TurtleBot 2."""
    mux, now, teleop = VelocityMux(SECOND), 0, -SECOND
    for name, pause in commands:
        now += pause
        assert mux.passes(name, now) == (name == TELEOP or now - teleop >= SECOND)
        if name == TELEOP:
            teleop = now


def test_each_robot_has_a_multiplexer_of_its_own_and_a_reset_starts_it_anew():
    """In a simulation of two; what goes to the base directly is no concern of theirs."""
    simulation = Simulation((0.0, 0.0, 0.0), (0.0, 1.0, 0.0))

    def obeys(robot, *name):
        before = simulation.robots[robot].resting
        simulation.robots[robot].command(0.2, 0.0, *name)
        return before and not simulation.robots[robot].resting

    simulation.robot.command(0.0, 0.0, TELEOP)
    assert not obeys(0, NAVI) and obeys(1, NAVI)
    assert obeys(0)
    simulation.reset(seed=0)
    assert obeys(0, NAVI)
