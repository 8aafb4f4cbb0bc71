"""Robots in a room under any commands: they bump, push, are put and reset, and stay robots.

After a reset the same commands do the same, to the bit, also in steps of time one by one.
"""

import contextlib
import math

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from odometry_tests.fuzzing import any_number
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import settings_of
from sim_turtlebot.geometry import about_z, height_of_z
from sim_turtlebot.robot.multiplexer import INPUTS
from sim_turtlebot.simulation import Simulation

NOISE = {'wheel_slip': 0.05, 'wheel_noise': 0.02, 'gyro_noise': 0.02, 'gyro_drift': 0.01,
         'scan': True, 'scan_noise': 0.01, 'scan_beams': 8}
ROOM = str(ROOT / 'sim_turtlebot/worlds/room.urdf')
CRATE = """<sdf version="1.6"><world name="w"><model name="crate"><pose>0.5 0.4 0.1 0 0 0</pose>
<link name="crate"><inertial><mass>0.3</mass><inertia><ixx>0.002</ixx><ixy>0</ixy><ixz>0</ixz>
<iyy>0.002</iyy><iyz>0</iyz><izz>0.002</izz></inertia></inertial><collision name="crate"><geometry>
<box><size>0.2 0.2 0.2</size></box></geometry></collision></link></model></world></sdf>"""
SHARE = 5  # of the other random sequences; the physics takes long
UPRIGHT = 0.9  # least height_of_z(): with the wheels up against another robot
LOWEST, HIGHEST = -0.001, 0.05  # m, of the footprint
SECOND = 240  # steps

robots = st.integers(0, 1)
places = st.floats(-2.5, 2.5)  # also within and behind a wall
events = st.one_of(
    st.tuples(st.just('command'), robots,
              st.sampled_from([0.7, -0.7, 0.0]) | st.floats(-0.7, 0.7) | any_number,
              st.sampled_from([math.pi, 0.0]) | st.floats(-4, 4) | any_number,
              st.sampled_from([None, *INPUTS])),
    # Where it ends, time may stand still: at any step, not only at an odometry.
    st.tuples(st.just('run'), robots, st.integers(1, 50) | st.just(SECOND)),
    st.tuples(st.just('set_pose'), robots, st.tuples(places, places, st.sampled_from([0.0, 0.3])),
              st.floats(-math.pi, math.pi).map(about_z)),
    st.tuples(st.just('reset_odometry'), robots))
episodes = st.lists(events, min_size=1, max_size=10)


def play(simulation, episode, stride=math.inf):
    """Return all that there is to see of the robots; time goes on by at most so many steps at once."""
    timeline, robots, seen, has_dropped = simulation.timeline, simulation.robots, [], False

    def look():
        number = timeline.odometry_count
        # As text: two zeros may differ in their sign.
        seen.append(repr((timeline.now, number, [
            (robot.odometry, robot.ground_truth, robot.wheels, robot.gyro.heading, robot.gyro.rate,
             robot.scanner.scan(number).tolist()) for robot in robots])))
        for robot in robots:
            truth = robot.ground_truth
            assert all(math.isfinite(number) for part in (*truth, *robot.odometry, *robot.wheels) for number in part)
            assert truth.position[2] >= LOWEST
            assert has_dropped or height_of_z(truth.orientation) > UPRIGHT and truth.position[2] <= HIGHEST

    for name, robot, *arguments in [*episode, ('run', 0, 0)]:
        look()
        if name == 'run':
            end = timeline.steps + arguments[0]
            while timeline.steps < end:
                if simulation.advance(min(end, timeline.steps + stride)):
                    look()
        elif name == 'reset_odometry':
            robots[robot].reset_odometry()
        else:
            with contextlib.suppress(ValueError):  # a number is not finite, or something is in the way
                if name == 'command':
                    robots[robot].command(*arguments)
                else:
                    robots[robot].set_pose(*arguments)
                    has_dropped = has_dropped or arguments[0][2] > 0
    return seen


@pytest.fixture(scope='module')
def worlds(tmp_path_factory):
    """Return the world files by their names: none, one with walls, one with a crate to push."""
    crate = tmp_path_factory.mktemp('worlds') / 'crate.sdf'
    crate.write_text(CRATE)
    return {'floor': '', 'room': ROOM, 'crate': str(crate)}


@settings(max_examples=settings.default.max_examples // SHARE)
@given(st.sampled_from([20.0, 7.0]), st.sampled_from(['world', 'encoder']),
       st.sampled_from(['floor', 'room', 'crate']), episodes, episodes)
@example(7.0, 'world', 'floor', [('command', 0, 0.5, 0.0), ('run', 0, 7), ('command', 0, -0.3, 1.0),
                           ('run', 0, SECOND)], [])
def test_after_any_other_episode_one_repeats_itself(worlds, rate, source, world, episode, other):
    """Time, poses, torques, odometry, gyro, scan and their noise, the multiplexer, and a pushed crate."""
    simulation = Simulation(
        settings_of(robots=2, odom_rate=rate, odometry_source=source, world=worlds[world], **NOISE))
    first = play(simulation, episode)
    simulation.reset(seed=1)
    play(simulation, other)
    simulation.reset(seed=0)
    for before, after in zip(first, play(simulation, episode, stride=1)):
        assert after == before
