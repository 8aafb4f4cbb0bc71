"""Whom of several controllers the robot obeys."""

from hypothesis import given
from hypothesis import strategies as st
from odometry_tests.simulation import Simulation
from sim_turtlebot.velocity_mux import INPUTS, TIMEOUT, VelocityMux

TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
SECOND = 10**9  # ns
STEP = SECOND // 20


def passed(*commands):
    """Return which of the commands, (input, time in ns), a new multiplexer passes on."""
    mux = VelocityMux()
    return [mux.passes(*command) for command in commands]


def test_the_inputs_are_those_of_turtlebot_bringup():
    """As in its param/mux.yaml."""
    assert (INPUTS, TIMEOUT) == ({TELEOP: 7, NAVI: 5}, SECOND)


def test_an_input_alone_is_passed_on():
    """Whichever it is, however long it was silent."""
    for name in INPUTS:
        assert all(passed((name, 0), (name, STEP), (name, 10 * SECOND)))


def test_the_higher_priority_takes_over_at_once():
    """And the lower one is kept out while it speaks."""
    assert passed((NAVI, 0), (TELEOP, STEP), (NAVI, 2 * STEP), (TELEOP, 3 * STEP)) == [
        True, True, False, True]


def test_the_lower_priority_is_back_a_second_after_the_last_word():
    """Not a nanosecond earlier; the last word counts, not the first."""
    assert passed((TELEOP, 0), (TELEOP, STEP), (NAVI, STEP + SECOND - 1),
                  (NAVI, STEP + SECOND)) == [True, True, False, True]


def test_what_is_kept_out_keeps_nobody_in():
    """Commands that are not passed on extend nothing."""
    assert passed((TELEOP, 0), (NAVI, SECOND - 1), (NAVI, SECOND), (TELEOP, SECOND)) == [
        True, False, True, True]


def test_after_a_restart_nobody_is_kept_out():
    """Time has gone back, and so has the multiplexer."""
    mux = VelocityMux()
    mux.passes(TELEOP, 100 * SECOND)
    mux.restart()
    assert mux.passes(NAVI, 0)


@given(st.lists(st.tuples(st.sampled_from([TELEOP, NAVI]), st.integers(0, 2 * SECOND)), max_size=50))
def test_teleop_is_always_obeyed_and_navi_when_teleop_is_silent(pauses):
    """Against the rule itself, for the two inputs of a TurtleBot 2."""
    mux, now, teleop = VelocityMux(), 0, -SECOND
    for name, pause in pauses:
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
