"""A tutorial without ROS: what comes out, and that it is the same each time.

test_sweep_replay shows that the nodes do the same in lockstep, to the last bit.
"""

import math

import pytest
from odometry_tools.sweep.closed_loop import run

# The errors and the corrections of docs/calibration.md.
ERRORS = {'odometry_source': 'encoder', 'gyro': False, 'wheel_diameter_ratio': 1.005, 'wheel_separation_ratio': 1.02}
CORRECTED = {**ERRORS, 'left_wheel_radius_multiplier': 0.99752, 'right_wheel_radius_multiplier': 1.00248,
             'wheel_separation_multiplier': 1.01995}


def test_distances_and_headings_count_from_the_start():
    """At a speed at which no wheel slips for a moment, which may turn the robot a little; errors are minus the target."""
    slow = {'distance': 0.1, 'speed': 0.1}
    here, there = run('move', slow), run('move', {**slow, 'x': 3.0, 'y': -2.0, 'yaw': 2.0})
    for name in 'moved', 'true_distance', 'sideways', 'heading':
        assert there[name] == pytest.approx(here[name], abs=2e-3), name
    assert here['ended'] == 'arrived'
    assert here['moved_error'] == here['moved'] - 0.1 and here['true_error'] == here['true_distance'] - 0.1


@pytest.mark.parametrize('target, heading', [(90, 90), (180, 180), (270, -90)])
def test_a_robot_turns_to_a_heading(target, heading):
    metrics = run('rotate', {'target': target, 'kp': 2})
    off = math.remainder(metrics['true_heading'] - heading, 360)
    assert metrics['ended'] == 'arrived' and abs(off) < 0.11 and metrics['overshoot'] < 0.2
    assert metrics['true_error'] == pytest.approx(off, abs=1e-9)
    assert metrics['heading_error'] == pytest.approx(off, abs=1e-3)


def test_the_corrections_of_the_driver_end_the_errors_of_the_robot():
    bent, straight = (run('move', robot)['sideways'] for robot in (ERRORS, CORRECTED))
    assert bent == pytest.approx(0.0434, abs=0.001) and abs(straight) < 0.001
    short, exact = (run('rotate', {**robot, 'kp': 1})['true_error'] for robot in (ERRORS, CORRECTED))
    assert short - exact == pytest.approx(90 / 1.02 - 90, abs=0.05) and abs(exact) < 0.2
