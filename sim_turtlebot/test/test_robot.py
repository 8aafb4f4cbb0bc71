"""What the robot does with commands: limits, stops, resets, whom it obeys, and being pushed."""

import math
import random

import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_tests.simulation import Simulation
from sim_turtlebot.robot.multiplexer import VelocityMux

TELEOP, NAVI = 'cmd_vel_mux/input/teleop', 'cmd_vel_mux/input/navi'
SECOND = 10**9  # ns
pauses = st.sampled_from([0, SECOND - 1, SECOND]) | st.integers(0, 2 * SECOND)  # ns
ODOMETRIES = 150
SPEEDS = [0.0, 0.1, 0.5, -0.3]  # m/s
TURNS = [0.0, 0.0, 1.0, -2.0]  # rad/s


def speeds(simulation):
    truth = simulation.robot.ground_truth
    return truth.linear[0], truth.angular[2]


@pytest.mark.parametrize('command, expected', [
    ((-1e300, 0.0), (-0.7, 0.0)), ((0.0, 4.0), (0.0, math.pi)), ((0.8, -100.0), (0.7, -math.pi)),
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
        simulation.command(0.2, 0.0, robot, *name)
        return before and not simulation.robots[robot].resting

    simulation.command(0.0, 0.0, 0, TELEOP)
    assert not obeys(0, NAVI) and obeys(1, NAVI)
    assert obeys(0)
    simulation.reset(seed=0)
    assert obeys(0, NAVI)


def drive(odom_rate, seed, steps):
    """Drive at random in so many steps at a time; return all that there is to publish."""
    rng, simulation = random.Random(seed), Simulation(odom_rate=odom_rate, cmd_vel_timeout=0.6)
    robot, timeline, states = simulation.robots[0], simulation.timeline, []
    for _ in range(ODOMETRIES):
        if rng.random() < 0.2:
            simulation.command(rng.choice(SPEEDS), rng.choice(TURNS))
        while not simulation.advance(timeline.steps + steps):
            pass
        states.append((timeline.now, robot.odometry, robot.ground_truth, robot.wheels))
    return states


@pytest.mark.parametrize('seed, odom_rate', [*enumerate([20.0, 10.0, 50.0, 7.0])])
def test_they_are_the_same_to_the_last_bit_as_one_by_one(seed, odom_rate):
    """Poses, velocities, and the torques of motors that accelerate, turn, brake and rest."""
    one_by_one = drive(odom_rate, seed, 1)
    for number, state in enumerate(drive(odom_rate, seed, 10**6)):
        assert state == one_by_one[number], f'odometry {number}'
    assert len({wheels for *_, wheels in one_by_one}) > ODOMETRIES / 4
