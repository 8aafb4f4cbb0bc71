"""Robots in a room under any commands: they bump, push, are reset, and stay robots."""

import math

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, rule
from odometry_common.geometry import about_z, yaw_of
from odometry_tests.fuzzing import PHYSICS_SHARE, any_number, sequence_count
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import Simulation, lean

from odometry_common import kobuki

ROOM = str(ROOT / 'sim_turtlebot' / 'worlds' / 'room.urdf')
PERIOD = 0.05  # s between two looks at the robots
FASTEST_RIM = kobuki.MAX_LINEAR_SPEED + kobuki.MAX_ANGULAR_SPEED * kobuki.WHEEL_SEPARATION / 2
FASTEST_WHEEL = FASTEST_RIM / kobuki.WHEEL_RADIUS
OVERSHOOT = 1.1  # of a wheel that comes free from a wall, say
LARGEST_LEAN = 25.0  # degrees, with the wheels up against another robot
LOWEST, HIGHEST = -0.001, 0.05  # m, of the footprint
STANDING = (0.0, 0.0)
STEPS = 15  # events in a sequence

SOURCES = {
    'world': {'odometry_source': 'world'},
    'encoder': {'odometry_source': 'encoder', 'gyro': False},
    'gyro': {'odometry_source': 'encoder'},
    'noisy': {'odometry_source': 'encoder', 'wheel_slip': 0.05, 'wheel_noise': 0.02,
              'gyro_noise': 0.02},
}

yaws = st.floats(-math.pi, math.pi)
places = st.floats(-2.5, 2.5)  # m, also within and behind a wall
robots = st.integers(0, 1)
speeds = st.one_of(st.sampled_from([0.7, -0.7, 0.1, 0.0]), st.floats(-1, 1), any_number)
turn_speeds = st.one_of(st.sampled_from([math.pi, -math.pi, 0.0]), st.floats(-4, 4), any_number)


def numbers_of(robot):
    """Return every number that a robot shows."""
    yield from (number for motion in (robot.ground_truth, robot.odometry)
                for part in motion for number in part)
    yield from (number for part in robot.wheels for number in part)


class RobotMachine(RuleBasedStateMachine):
    """Two robots, one behind the other, in a room of four metres."""

    @initialize(first=yaws, second=yaws, source=st.sampled_from(sorted(SOURCES)),
                timeout=st.sampled_from([0.0, 0.6]))
    def start(self, first, second, source, timeout):
        self.source = source
        self.simulation = Simulation(
            (0.0, 0.0, first), (-0.6, 0.0, second), world=ROOM, cmd_vel_timeout=timeout,
            **SOURCES[source])
        self.note_origins()
        self.look()

    @rule(robot=robots, linear=speeds, angular=turn_speeds)
    def command(self, robot, linear, angular):
        """Command a twist; one that is not finite is refused."""
        if math.isfinite(linear) and math.isfinite(angular):
            self.simulation.command(linear, angular, robot)
        else:
            with pytest.raises(ValueError, match='is not finite'):
                self.simulation.command(linear, angular, robot)

    @rule(periods=st.integers(1, 20))
    def run_on(self, periods):
        """Let time pass; between two of these it stands, as while the simulation is paused."""
        for _ in range(periods):
            self.simulation.run(PERIOD)
            self.look()

    @rule(robot=robots)
    def reset_odometry(self, robot):
        self.simulation.robots[robot].reset_odometry()
        self.origins[robot] = self.simulation.robots[robot].ground_truth
        x, y, _ = self.simulation.robots[robot].odometry.position
        assert (x, y) == (0.0, 0.0)

    @rule(robot=robots, x=places, y=places, yaw=yaws)
    def set_pose(self, robot, x, y, yaw):
        """Put a robot somewhere, where there may be no room."""
        robot = self.simulation.robots[robot]
        before, _ = robot.body.pose()
        try:
            robot.set_pose((x, y, 0.0), about_z(yaw))
        except ValueError:
            assert robot.body.pose()[0] == before
        else:
            assert robot.ground_truth.position[:2] == (x, y)
            assert robot.resting

    @rule()
    def reset_simulation(self):
        self.simulation.reset()
        for robot, start in zip(self.simulation.robots, ((0.0, 0.0), (-0.6, 0.0))):
            assert robot.ground_truth.position[:2] == start
            assert robot.resting
        self.note_origins()
        self.look()

    @rule()
    def stop_and_wait(self):
        """Command zero, not always for the first time, and wait until the robots have braked."""
        for robot, _ in enumerate(self.simulation.robots):
            self.simulation.command(*STANDING, robot)
        self.run_on(20)
        for robot in self.simulation.robots:
            assert math.hypot(*robot.ground_truth.linear) < 0.05

    def teardown(self):
        """Free the world, of 35 MB; hypothesis keeps the machine for a while."""
        self.simulation = None

    def note_origins(self):
        """Remember where each odometry has begun."""
        self.origins = [robot.ground_truth for robot in self.simulation.robots]

    def look(self):
        """Check all that must hold for each robot at any time."""
        for robot, origin in zip(self.simulation.robots, self.origins):
            assert all(map(math.isfinite, numbers_of(robot)))
            assert max(map(abs, robot.wheels[1])) <= FASTEST_WHEEL * OVERSHOOT
            assert lean(robot.ground_truth) <= LARGEST_LEAN
            assert LOWEST <= robot.ground_truth.position[2] <= HIGHEST
            assert math.hypot(*robot.odometry.orientation) == pytest.approx(1.0, abs=1e-6)
            if self.source == 'world':
                self.compare(robot, origin)

    def compare(self, robot, origin):
        """Check a world odometry against the path from where it has begun."""
        x, y, _ = robot.odometry.position
        true_x, true_y = (now - then for now, then in
                          zip(robot.ground_truth.position[:2], origin.position[:2]))
        assert math.hypot(x, y) == pytest.approx(math.hypot(true_x, true_y), abs=1e-9)
        turn = yaw_of(robot.ground_truth.orientation) - yaw_of(origin.orientation)
        error = math.remainder(yaw_of(robot.odometry.orientation) - turn, math.tau)
        assert error == pytest.approx(0.0, abs=1e-9)


TestRobot = RobotMachine.TestCase
TestRobot.settings = settings(
    TestRobot.settings, max_examples=sequence_count(PHYSICS_SHARE), stateful_step_count=STEPS)
