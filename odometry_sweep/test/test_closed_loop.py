"""A tutorial without ROS: what comes out, and that it is the same each time.

test_sweep_replay shows that the nodes do the same in lockstep, to the last bit.
"""

import json
import math
import subprocess
import sys

import pytest
from odometry_sweep.campaign import Campaign
from odometry_sweep.closed_loop import follow, run, run_parameters
from odometry_sweep.running import side_by_side
from odometry_tests.scripts import ROOT
from sim_turtlebot.odometry import STILL, Motion
from sim_turtlebot.rotations import about_z

SHORT = {'distance': 0.1, 'speed': 0.3}
NOISY = {'odometry_source': 'encoder', 'wheel_noise': 0.01, 'wheel_slip': 0.02}
ALONE = """
import json, sys
from odometry_sweep.closed_loop import run
print(json.dumps(run(*json.loads(sys.argv[1]))))
"""
LYING = (math.sin(math.pi / 4), 0.0, 0.0, math.cos(math.pi / 4))


def end_of(tutorial, parameters, orientations):
    """Return the metrics of a robot that only turns, without physics."""
    part, _ = run_parameters(tutorial, parameters)
    motions = (Motion(STILL, orientation, STILL, STILL) for orientation in orientations)
    ticks = ((0.05 * number, motion, motion) for number, motion in enumerate(motions))
    return follow(part, ticks, lambda *_: None)


def test_two_metres_are_driven_as_the_demo_drives_them():
    """With the numbers that README.md shows, and no turn."""
    metrics = run('move', {})
    assert metrics['ended'] == 'arrived'
    assert round(metrics['moved'], 3) == round(metrics['true_distance'], 3) == 2.005
    assert metrics['moved_error'] == metrics['moved'] - 2.0
    assert metrics['true_error'] == metrics['true_distance'] - 2.0
    assert abs(metrics['sideways']) < 1e-3 and abs(metrics['heading']) < 0.05
    assert 20.0 < metrics['time'] < 20.5


def test_distances_and_headings_count_from_the_start():
    """PyBullet computes with single precision in places."""
    here, there = run('move', SHORT), run('move', {**SHORT, 'x': 3.0, 'y': -2.0, 'yaw': 2.0})
    for name in ('moved', 'true_distance', 'sideways', 'heading'):
        assert there[name] == pytest.approx(here[name], abs=2e-3), name


@pytest.mark.parametrize('target, heading', [(90, 90), (180, 180), (270, -90)])
def test_a_robot_turns_to_a_heading(target, heading):
    """The shorter way, as close as the demo demands."""
    metrics = run('rotate', {'target': target, 'kp': 2})
    assert metrics['ended'] == 'arrived'
    off = math.remainder(metrics['true_heading'] - heading, 360)
    assert metrics['true_error'] == pytest.approx(off, abs=1e-9) and abs(off) < 0.11
    assert metrics['heading_error'] == pytest.approx(off, abs=1e-3)
    assert metrics['overshoot'] < 0.2


def test_a_gain_that_is_too_great_for_its_rate_overshoots():
    """The controller looks at the heading once a second."""
    assert run('rotate', {'kp': 1.5, 'rate': 1, 'cmd_vel_timeout': 0})['overshoot'] > 5


def test_a_robot_before_a_wall_is_late():
    """Its encoders go on counting, but the world says where it is."""
    room = str(ROOT / 'sim_turtlebot' / 'worlds' / 'room.urdf')
    metrics = run('move', {'world': room, 'distance': 4, 'speed': 0.2})
    assert metrics['ended'] == 'late'
    assert metrics['time'] == pytest.approx(1.5 * 4 / 0.2 + 10, abs=0.1)
    assert metrics['true_distance'] < 2


def test_a_robot_on_its_side_has_fallen():
    """And is not only late."""
    assert end_of('move', SHORT, [LYING] * 1000)['ended'] == 'fallen'


def test_a_heading_behind_the_robot_is_no_overshoot():
    """The error changes its sign there."""
    assert end_of('rotate', {'target': 180}, map(about_z, [0.0, -0.1, math.pi]))['overshoot'] == 0


@pytest.mark.parametrize('tutorial, parameters', [
    ('move', SHORT), ('move', {**SHORT, **NOISY, 'seed': 7}), ('rotate', {'kp': 2, **NOISY})])
def test_a_run_comes_out_the_same_in_a_new_process_and_after_others(tutorial, parameters):
    """To the last bit, in the world of other runs or after another world."""
    alone = subprocess.run([sys.executable, '-c', ALONE, json.dumps([tutorial, parameters])],
                           check=True, capture_output=True, text=True).stdout
    for before in ({**SHORT, 'speed': -0.7}, {**SHORT, 'odom_rate': 50}):
        run('move', before)
        assert [run(tutorial, parameters) for _ in range(2)] == [json.loads(alone)] * 2


def test_two_processes_give_the_rows_that_one_gives():
    """In the same order, to the last bit."""
    campaign = Campaign('move', 3, {**{name: [value] for name, value in {**SHORT, **NOISY}.items()},
                                    'speed': [0.3, 0.5]}, {})
    rows = []
    for jobs in (1, 2):
        with side_by_side(jobs) as run_all:
            rows.append([*run_all(campaign)])
    one, two = rows
    assert one == two and len({metrics['moved'] for _, metrics in one}) == 6
