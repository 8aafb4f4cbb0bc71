"""Whom of several controllers the robot obeys."""

from hypothesis import given
from hypothesis import strategies as st
from odometry_tests.simulation import Simulation
from sim_turtlebot.robot.multiplexer import VelocityMux

TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
SECOND = 10**9  # ns


pauses = st.sampled_from([0, SECOND - 1, SECOND]) | st.integers(0, 2 * SECOND)  # ns


@given(st.lists(st.tuples(st.sampled_from([TELEOP, NAVI]), pauses), max_size=50))
def test_teleop_is_always_obeyed_and_navi_when_teleop_is_silent(commands):
    """Against the rule itself, for the two inputs of a TurtleBot 2."""
    mux, now, teleop = VelocityMux(), 0, -SECOND
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
        simulation.command(0.2, 0.0, robot, *name)
        return before and not simulation.robots[robot].resting

    simulation.command(0.0, 0.0, 0, TELEOP)
    assert not obeys(0, NAVI) and obeys(1, NAVI)
    assert obeys(0)
    simulation.reset()
    assert obeys(0, NAVI)
