"""A tutorial without ROS: what comes out, and that it is the same each time.

That it is also what the nodes do in lockstep, to the last bit, is for test_sweep_replay to show.
"""

import json
import math
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from odometry_common.geometry import about_z
from odometry_sweep import closed_loop
from odometry_sweep.campaign import Campaign
from odometry_sweep.closed_loop import follow, run
from odometry_sweep.reading import read
from odometry_sweep.running import side_by_side
from odometry_tests.fuzzing import PHYSICS_SHARE, sequence_count
from odometry_tests.scripts import ROOT
from sim_turtlebot.odometry import STILL, Motion

SHORT = {'distance': 0.1, 'speed': 0.3}
NOISY = {'odometry_source': 'encoder', 'wheel_noise': 0.01, 'wheel_slip': 0.02}
ALONE = """
import json, sys
from odometry_sweep.closed_loop import run
print(json.dumps(run(*json.loads(sys.argv[1]))))
"""
ROBOTS = st.fixed_dictionaries({'odometry_source': st.sampled_from(['world', 'encoder'])}, optional={
    'wheel_slip': st.floats(0, 0.05), 'wheel_noise': st.floats(0, 0.05), 'gyro': st.booleans()})
MOVES = st.tuples(st.just('move'), st.fixed_dictionaries({
    'distance': st.floats(0.01, 0.5), 'speed': st.floats(0.1, 0.7) | st.floats(-0.7, -0.1)}))
ROTATIONS = st.tuples(st.just('rotate'), st.fixed_dictionaries({
    'target': st.floats(-180, 180), 'kp': st.floats(1, 3)}))
STARTS = st.fixed_dictionaries({name: st.floats(-9, 9) for name in ('x', 'y')},
                               optional={'yaw': st.floats(-3, 3),
                                         'odom_rate': st.sampled_from([10.0, 30.0, 62.5])})
LYING = (math.sin(math.pi / 4), 0.0, 0.0, math.cos(math.pi / 4))


def test_two_metres_are_driven_as_the_demo_drives_them():
    """The figures that README.md shows, and no turn."""
    figures = run('move', {})
    assert figures['ended'] == 'arrived'
    assert round(figures['moved'], 3) == round(figures['true_distance'], 3) == 2.005
    assert figures['moved_error'] == figures['moved'] - 2.0
    assert figures['true_error'] == figures['true_distance'] - 2.0
    assert abs(figures['sideways']) < 1e-3 and abs(figures['heading']) < 0.05
    assert 20.0 < figures['time'] < 20.5


def test_where_it_starts_and_looks_changes_little():
    """Distances and headings are from there; PyBullet computes with single precision in places."""
    here, there = run('move', SHORT), run('move', {**SHORT, 'x': 3.0, 'y': -2.0, 'yaw': 2.0})
    for name in ('moved', 'true_distance', 'sideways', 'heading'):
        assert there[name] == pytest.approx(here[name], abs=2e-3), name


@pytest.mark.parametrize('target, heading', [(90, 90), (-45, -45), (180, 180), (270, -90)])
def test_a_heading_is_turned_to(target, heading):
    """The shorter way, within what the demo calls arrived."""
    figures = run('rotate', {'target': target, 'kp': 2})
    assert figures['ended'] == 'arrived'
    off = math.remainder(figures['true_heading'] - heading, 360)
    assert figures['true_error'] == pytest.approx(off, abs=1e-9) and abs(off) < 0.11
    assert figures['heading_error'] == pytest.approx(off, abs=1e-3)
    assert figures['overshoot'] < 0.2


def test_a_gain_that_is_too_great_for_its_rate_overshoots():
    """By a look at the heading in each second."""
    parameters = {'kp': 1.5, 'rate': 1, 'cmd_vel_timeout': 0}
    assert run('rotate', parameters)['overshoot'] > 5


def test_a_robot_that_does_not_arrive_is_given_up():
    """Before a wall; by its encoders it goes on, and by its own account arrives."""
    room = str(ROOT / 'sim_turtlebot' / 'worlds' / 'room.urdf')
    figures = run('move', {'world': room, 'distance': 4, 'speed': 0.2})
    assert figures['ended'] == 'late'
    assert figures['time'] == pytest.approx(1.5 * 4 / 0.2 + 10, abs=0.1)
    assert figures['true_distance'] < 2


def test_a_robot_that_lies_on_its_side_has_fallen():
    """It can only be late, too."""
    part, _ = read('move', SHORT)
    lying = Motion(STILL, LYING, STILL, STILL)
    ticks = ((0.05 * number, lying, lying) for number in range(1000))
    assert follow(part, ticks, lambda *_: None)['ended'] == 'fallen'


def test_a_heading_behind_the_robot_is_no_overshoot():
    """The error changes its sign there."""
    part, _ = read('rotate', {'target': 180})
    yaws = [0.0, -0.1, math.pi]
    ticks = ((0.05 * number, *[Motion(STILL, about_z(yaw), STILL, STILL)] * 2)
             for number, yaw in enumerate(yaws))
    assert follow(part, ticks, lambda *_: None)['overshoot'] == 0


@pytest.mark.parametrize('tutorial, parameters', [
    ('move', SHORT), ('move', {**SHORT, **NOISY, 'seed': 7}), ('rotate', {'kp': 2, **NOISY})])
def test_a_run_comes_out_the_same_in_a_new_process_and_after_others(tutorial, parameters):
    """To the last bit: PyBullet is emptied between two runs."""
    alone = subprocess.run([sys.executable, '-c', ALONE, json.dumps([tutorial, parameters])],
                           check=True, capture_output=True, text=True).stdout
    run('move', {**SHORT, 'odom_rate': 50})
    assert [run(tutorial, parameters) for _ in range(2)] == [json.loads(alone)] * 2


@settings(deadline=None, max_examples=sequence_count(PHYSICS_SHARE))
@given(st.just({}) | STARTS, st.lists(st.tuples(MOVES | ROTATIONS, ROBOTS), min_size=2, max_size=3))
def test_a_world_that_is_used_again_is_as_good_as_new(start, runs):
    """The last of several runs from the same place, beside one that goes first; to the last bit."""
    for (tutorial, values), robot in runs:
        parameters = {**start, **values, **robot}
        figures = run(tutorial, parameters)
    closed_loop._world_of_robots.cache_clear()
    assert run(tutorial, parameters) == figures


def test_two_processes_give_the_rows_that_one_gives():
    """In the same order, to the last bit."""
    campaign = Campaign('move', 3, {**{name: [value] for name, value in {**SHORT, **NOISY}.items()},
                                    'speed': [0.3, 0.5]}, {})
    rows = []
    for jobs in (1, 2):
        with side_by_side(jobs) as run_all:
            rows.append([*run_all(campaign)])
    one, two = rows
    assert one == two and len(one) == 6
    assert len({figures['moved'] for _, figures in one}) == 6
