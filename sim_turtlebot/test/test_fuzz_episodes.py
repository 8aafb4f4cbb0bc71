"""A second episode is as good as the first: after a reset the same commands do the same, to the bit."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from odometry_common.geometry import about_z
from odometry_tests.fuzzing import sequence_count
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import settings_of
from sim_turtlebot.simulation import Simulation
from sim_turtlebot.velocity_mux import INPUTS

NOISE = {'wheel_slip': 0.05, 'wheel_noise': 0.02, 'gyro_noise': 0.02, 'gyro_drift': 0.01,
         'scan': True, 'scan_noise': 0.01, 'scan_beams': 8, 'seed': 7}
ROOM = str(ROOT / 'sim_turtlebot' / 'worlds' / 'room.urdf')
CRATE = """<sdf version="1.6"><world name="w"><model name="crate"><pose>0.5 0.4 0.1 0 0 0</pose>
<link name="crate"><inertial><mass>0.3</mass><inertia><ixx>0.002</ixx><ixy>0</ixy><ixz>0</ixz>
<iyy>0.002</iyy><iyz>0</iyz><izz>0.002</izz></inertia></inertial><collision name="crate"><geometry>
<box><size>0.2 0.2 0.2</size></box></geometry></collision></link></model></world></sdf>"""
SHARE = 3  # one in three sequences, 100 of 300

robots = st.integers(0, 1)
places, yaws = st.floats(-1.5, 1.5), st.floats(-math.pi, math.pi)
events = st.one_of(
    st.tuples(st.just('command'), robots, st.sampled_from([0.7, -0.7, 0.0]) | st.floats(-0.7, 0.7),
              st.sampled_from([math.pi, 0.0]) | st.floats(-4, 4), st.sampled_from([None, *INPUTS])),
    # Where it ends, time may stand still: at any step, not only at an odometry.
    st.tuples(st.just('run'), st.integers(1, 50)),
    st.tuples(st.just('set_pose'), robots, places, places, st.sampled_from([0.0, 0.3]), yaws),
    st.tuples(st.just('reset_odometry'), robots))
episodes = st.lists(events, min_size=1, max_size=10)


class Episodes:
    """Two robots side by side, and all that there is to see of them."""

    def __init__(self, source, world):
        self._simulation = Simulation(
            settings_of(robots=2, odometry_source=source, world=world, **NOISE))

    def play(self, episode):
        """Return what is seen during a list of events."""
        self._seen = []
        self._look()
        for name, *arguments in episode:
            getattr(self, f'_{name}')(*arguments)
            self._look()
        return self._seen

    def reset(self):
        self._simulation.reset()

    def _command(self, robot, linear, angular, mux_input):
        self._simulation.command(linear, angular, robot, mux_input)

    def _run(self, steps):
        timeline = self._simulation.timeline
        end = timeline.steps + steps
        while timeline.steps < end:
            if self._simulation.advance(end):
                self._look()

    def _set_pose(self, robot, x, y, z, yaw):
        try:
            self._simulation.robots[robot].set_pose((x, y, z), about_z(yaw))
        except ValueError as error:
            self._seen.append(str(error))

    def _reset_odometry(self, robot):
        self._simulation.robots[robot].reset_odometry()

    def _look(self):
        timeline = self._simulation.timeline
        number = timeline.odometry_count
        # As text: two zeros may differ in their sign.
        self._seen.append(repr((timeline.now, number, [
            (robot.odometry, robot.ground_truth, robot.wheels, robot.gyro.heading, robot.gyro.rate,
             robot.scanner.scan(number).tolist()) for robot in self._simulation.robots])))


@pytest.fixture(scope='module')
def worlds(tmp_path_factory):
    """Return the world files by their names: none, one with walls, one with a crate to push."""
    crate = tmp_path_factory.mktemp('worlds') / 'crate.sdf'
    crate.write_text(CRATE)
    return {'floor': '', 'room': ROOM, 'crate': str(crate)}


@settings(max_examples=sequence_count(SHARE))
@given(st.sampled_from(['world', 'encoder']), st.sampled_from(['floor', 'room', 'crate']), episodes,
       episodes)
def test_after_any_other_episode_one_repeats_itself(worlds, source, world, episode, other):
    """Time, poses, odometry, gyro, scan and their noise, the multiplexer, and a pushed crate."""
    simulated = Episodes(source, worlds[world])
    first = simulated.play(episode)
    simulated.reset()
    simulated.play(other)
    simulated.reset()
    for before, after in zip(first, simulated.play(episode)):
        assert after == before
