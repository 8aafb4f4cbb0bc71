"""When a demo's robot has arrived, and what is said of it, from scripted messages."""

import math

import pytest
from odometry_tools.runs.tutorials import TUTORIALS, follow
from sim_turtlebot.geometry import about_z
from sim_turtlebot.robot.odometry import STILL, Motion

UPRIGHT, LYING = about_z(0.0), (math.sin(math.pi / 4), 0.0, 0.0, math.cos(math.pi / 4))
DRIVE = [0.005 * step for step in range(400)]


def metrics_of(loop, motions):
    """Return the metrics of a robot that does these Motions, without physics."""
    ticks = ((0.05 * number, motion, motion) for number, motion in enumerate(motions))
    return follow(loop, ticks, lambda *_: None)


@pytest.mark.parametrize('end, arrives', [
    ([2.0, 2.002, 2.002], True), ([2.0], False), ([], False), ([2.0 + 0.005 * step for step in range(999)], False)])
def test_a_robot_has_arrived_once_it_rests_at_its_goal(end, arrives):
    positions, loop = [*DRIVE, *end], TUTORIALS['move']({})
    metrics = metrics_of(loop, [Motion((x, 0.0, 0.0), UPRIGHT, ((x - before) / 0.05, 0.0, 0.0), STILL)
                                for x, before in zip(positions, [0.0, *positions])])
    assert (metrics['ended'] == 'arrived') == arrives
    if arrives:
        assert loop.progress() == (2.002 / 2, '2.00 of 2.00 m, 0.00 m/s') and metrics['moved'] == 2.002


@pytest.mark.parametrize('orientation, ended', [(UPRIGHT, 'late'), (LYING, 'fallen')])
def test_a_robot_that_does_not_arrive_is_late_or_has_fallen(orientation, ended):
    metrics = metrics_of(TUTORIALS['move']({'distance': 0.1, 'speed': 0.3}), 1000 * [Motion(STILL, orientation, STILL, STILL)])
    assert metrics['ended'] == ended and metrics['time'] == pytest.approx(10.55)


@pytest.mark.parametrize('target, yaws, overshoot', [(180, [0.0, -0.1, math.pi], 0), (90, [0.0, 1.8, 1.5708], 13.13)])
def test_overshoot_is_beyond_the_target_but_not_behind_the_robot(target, yaws, overshoot):
    metrics = metrics_of(TUTORIALS['rotate']({'target': target}), [Motion(STILL, about_z(yaw), STILL, STILL) for yaw in yaws])
    assert metrics['overshoot'] == pytest.approx(overshoot, abs=0.01)
