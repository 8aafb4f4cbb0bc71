"""Several steps of the physics in one call of PyBullet."""

import random

import pytest
from odometry_tests.simulation import settings_of
from sim_turtlebot.simulation import Simulation

ODOMETRIES = 150
SPEEDS = [0.0, 0.1, 0.5, -0.3]  # m/s
TURNS = [0.0, 0.0, 1.0, -2.0]  # rad/s


def drive(odom_rate, seed, steps):
    """Drive at random in so many steps at a time; return all that there is to publish."""
    rng, simulation = random.Random(seed), Simulation(settings_of(odom_rate=odom_rate))
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
