"""What the robot does with commands: limits, stops, resets, and being pushed."""

import math

import pytest
from odometry_common.geometry import yaw_of
from odometry_tests.simulation import Simulation

STILL = (0.0, 0.0, 0.0)


def speeds(simulation):
    """Return the true forward (m/s) and turning speed (rad/s) of the first robot."""
    truth = simulation.robot.ground_truth
    return truth.linear[0], truth.angular[2]


@pytest.mark.parametrize('command, expected', [
    ((0.8, 0.0), (0.7, 0.0)), ((-1e300, 0.0), (-0.7, 0.0)), ((0.0, 4.0), (0.0, math.pi)),
    ((0.0, -1e300), (0.0, -math.pi)), ((100.0, -100.0), (0.7, -math.pi)),
    ((0.7, 0.0), (0.7, 0.0)), ((0.69, -3.1), (0.69, -3.1))])
def test_a_twist_that_it_cannot_do_is_clamped(command, expected):
    """0.7 m/s and half a turn per second, each on its own."""
    simulation = Simulation()
    simulation.drive(*command, 2.0)
    assert speeds(simulation) == pytest.approx(expected, rel=0.01, abs=0.01)


@pytest.mark.parametrize('command', [
    (math.nan, 0.0), (0.0, math.nan), (math.inf, 0.0), (0.1, -math.inf)])
def test_a_command_that_is_not_finite_is_refused_and_stops_it(command):
    """Better to stand than to guess."""
    simulation = Simulation()
    simulation.drive(0.3, 0.5, 1.0)
    with pytest.raises(ValueError, match='is not finite'):
        simulation.command(*command)
    simulation.run(1.0)
    assert simulation.robot.resting
    simulation.drive(0.3, 0.0, 1.0)
    assert speeds(simulation) == pytest.approx((0.3, 0.0), abs=0.01)


@pytest.mark.parametrize('velocity', [(0.3, 0.0), (0.0, 1.0)])
def test_it_stops_when_commands_cease(velocity):
    """0.6 s after the last one, as a Kobuki does, and not before."""
    simulation = Simulation(cmd_vel_timeout=0.6)
    for _ in range(10):
        simulation.drive(*velocity, 0.5)
        assert speeds(simulation) == pytest.approx(velocity, abs=0.01)
    simulation.run(0.1)
    assert speeds(simulation) == pytest.approx(velocity, abs=0.01)
    simulation.run(0.3)
    assert speeds(simulation) == pytest.approx((0.0, 0.0), abs=1e-3)
    simulation.drive(*velocity, 0.5)
    assert speeds(simulation) == pytest.approx(velocity, abs=0.01)


def test_a_timeout_below_a_step_of_time_is_no_lack_of_one():
    """The robot stops at the next step, before it has gone anywhere."""
    simulation = Simulation(cmd_vel_timeout=0.001)
    simulation.drive(0.3, 0.0, 1.0)
    assert speeds(simulation) == pytest.approx((0.0, 0.0), abs=1e-3)
    assert simulation.robot.ground_truth.position[0] < 0.01


def test_its_twist_is_in_its_own_frame():
    """Forwards is x wherever it looks."""
    simulation = Simulation((1.0, -2.0, 2.5))
    simulation.drive(0.2, 0.5, 3.0)
    for motion in (simulation.robot.ground_truth, simulation.robot.odometry):
        assert motion.linear == pytest.approx((0.2, 0.0, 0.0), abs=0.002)
        assert motion.angular == pytest.approx((0.0, 0.0, 0.5), abs=0.005)


def test_it_starts_where_it_is_put_and_its_odometry_at_zero():
    """The truth is in the world, and the odometry in a frame of the robot's own."""
    simulation = Simulation((12.5, -7.25, 1.2))
    (x, y, z), orientation, *velocity = simulation.robot.ground_truth
    assert (x, y) == (12.5, -7.25)
    assert z == pytest.approx(0.0, abs=5e-4)
    assert yaw_of(orientation) == pytest.approx(1.2, abs=1e-9)
    assert velocity == [STILL, STILL]
    assert simulation.robot.odometry.position[:2] == (0.0, 0.0)
    simulation.drive(0.5, 0.0, 2.0)
    assert simulation.robot.odometry.position[:2] == pytest.approx((1.0, 0.0), abs=0.05)


def test_its_wheels_roll_as_far_as_it_moves():
    """Left and right, forwards, and the outer one faster."""
    simulation = Simulation()
    simulation.drive(0.3, 0.4, 3.0)
    angles, velocities, _ = simulation.robot.wheels
    rim = [velocity * 0.035 for velocity in velocities]
    assert rim == pytest.approx([0.3 - 0.4 * 0.115, 0.3 + 0.4 * 0.115], rel=0.01)
    assert sum(angles) / 2 * 0.035 == pytest.approx(0.9, rel=0.05)


@pytest.mark.parametrize('source', ['world', 'encoder'])
def test_a_reset_of_the_odometry_makes_this_place_zero(source):
    """Also while it drives; the robot itself is not affected."""
    simulation = Simulation((3.0, 4.0, 1.0), odometry_source=source)
    simulation.drive(0.3, 0.5, 2.0)
    before = simulation.robot.ground_truth
    simulation.robot.reset_odometry()
    position, orientation, *_ = simulation.robot.odometry
    assert position[:2] == (0.0, 0.0)
    assert yaw_of(orientation) == pytest.approx(0.0, abs=1e-12)
    simulation.run(0.05)
    assert simulation.robot.ground_truth.position != before.position
    assert speeds(simulation) == pytest.approx((0.3, 0.5), abs=0.01)
    step = math.dist(simulation.robot.ground_truth.position, before.position)
    assert math.hypot(*simulation.robot.odometry.position[:2]) == pytest.approx(step, abs=2e-4)


@pytest.mark.parametrize('source', ['world', 'encoder'])
def test_a_reset_of_the_simulation_takes_it_back_to_its_start(source):
    """At rest, with its wheels and its odometry at zero, and able to take the same path again."""
    simulation = Simulation((3.0, 4.0, 1.0), odometry_source=source)
    robot = simulation.robot
    at_start = robot.ground_truth, robot.odometry, robot.wheels[:2]
    simulation.drive(0.5, 1.0, 3.0)
    first = robot.ground_truth
    simulation.reset()
    assert (robot.ground_truth, robot.odometry, robot.wheels[:2]) == at_start
    simulation.run(1.0)
    assert (robot.ground_truth, robot.odometry, robot.wheels[:2]) == at_start
    simulation.drive(0.5, 1.0, 3.0)
    assert robot.ground_truth.position == pytest.approx(first.position, abs=0.001)


def test_after_a_reset_it_moves_as_it_did_at_first():
    """To the last bit, also after a motion so small that PyBullet could keep its contacts."""
    simulation = Simulation()
    records = []
    for _ in range(3):
        records.append(simulation.drive(0.0, 0.3, 0.2))
        simulation.reset()
    assert records == [records[0]] * 3


def test_after_a_reset_an_old_command_is_forgotten():
    """The robot and its motors wait for a new one, though another robot drives."""
    simulation = Simulation((0, 0, 0), (0, 1, 0), cmd_vel_timeout=0.6)
    simulation.drive(0.5, 0.0, 0.5)
    simulation.reset()
    simulation.command(0.5, 0.0, robot=1)
    assert {motion.position[:2] for motion in simulation.run(0.5).odometry} == {(0.0, 0.0)}


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


def test_a_pushed_robot_still_obeys():
    """What has been pushed away drives back."""
    simulation = Simulation((0, 0, 0), (-0.6, 0, 0))
    simulation.command(0.2, 0.0, robot=1)
    simulation.run(3.0)
    simulation.command(-0.2, 0.0, robot=1)
    simulation.drive(0.3, 0.0, 2.0)
    assert speeds(simulation) == pytest.approx((0.3, 0.0), abs=0.01)
