"""Where the page draws the target of a tutorial's node."""

import math

import pytest
import rospy
from odometry_common.geometry import PlanarPose
from robot_view.targets import Targets

HERE = PlanarPose(1.0, 2.0, math.pi / 2)


@pytest.fixture
def targets(master):
    return Targets('/aim/')


def start(targets, node, **parameters):
    rospy.set_param(f'/aim/{node}', parameters)
    targets.find({f'/aim/{node}', '/other'})


@pytest.mark.parametrize('parameters, y', [
    ({'distance': 3.0}, 4.5), ({'distance': 3}, 4.5), ({}, 3.5), ({'distance': 3.0, 'speed': -0.2}, -0.5),
    ({'distance': 0.25}, 1.75)])
def test_the_goal_is_where_the_mover_stops(targets, parameters, y):
    """Half a metre has been driven; a negative speed drives backwards."""
    start(targets, 'test_movement', **parameters)
    targets.aim(HERE, 0.5)
    assert targets.distance == parameters.get('distance', 2.0)
    assert targets.goal[:2] == pytest.approx((1.0, y))


def test_a_goal_stays_until_another_mover_starts(targets):
    start(targets, 'test_movement', distance=3.0)
    targets.aim(HERE, 0.5)
    first = targets.goal
    targets.aim(PlanarPose(0.0, 0.0, 0.0), 1.0)
    targets.find(set())
    assert targets.goal == first and targets.distance == 3.0
    start(targets, 'test_movement', distance=1.0)
    targets.aim(PlanarPose(0.0, 0.0, 0.0), 0.0)
    assert targets.goal == pytest.approx((1.0, 0.0, 0.0))


@pytest.mark.parametrize('nodes, moved', [({'/aim/test_movement'}, 0.5), ({'/other'}, 0.5), ({'/aim/test_movement'}, None)])
def test_nobody_guesses_a_goal(targets, nodes, moved):
    """Neither of a relative mover, nor without a mover or a moved distance."""
    rospy.set_param('/aim/test_movement', {'relative': moved is not None})
    targets.find(nodes)
    targets.aim(HERE, moved)
    assert targets.goal is None


def test_the_rotators_target_is_there_while_it_runs(targets):
    start(targets, 'rotate_robot', target=30)
    assert targets.heading == 30.0
    targets.find(set())
    assert targets.heading is None
