"""How the robot in PyBullet moves, against what it was commanded."""

import math

import pytest
from odometry_tests.scripts import ROOT
from odometry_tests.simulation import Simulation
from sim_turtlebot.geometry import yaw_of

ROOM = str(ROOT / 'sim_turtlebot/worlds/room.urdf')
WALL, RADIUS = 2.0, 0.18  # m: the face of its wall, and the robot
STOPPING = 1.0  # s, more than enough to stand
STEP_RATE = 240  # Hz
TEN_MINUTES = 600.0  # s


def distance_between(a, b):
    """Return how far (m) the footprint has moved in the plane from Motion a to b."""
    return math.dist(a.position[:2], b.position[:2])


def total_turn(motions):
    yaws = [yaw_of(motion.orientation) for motion in motions]
    return sum(math.remainder(later - sooner, math.tau) for sooner, later in zip(yaws, yaws[1:]))


@pytest.mark.parametrize('source', ['world', 'encoder'])
def test_a_slow_base_reaches_a_share_of_what_is_commanded_and_its_odometry_shows_it(source):
    """Forwards and in a spin."""
    simulation = Simulation(speed_ratio=0.7, odometry_source=source)
    for command in (0.5, 0.0), (0.0, 1.0):
        simulation.drive(*command, 2.0)
        reached = [0.7 * part for part in command]
        for motion in simulation.robot.ground_truth, simulation.robot.odometry:
            assert [motion.linear[0], motion.angular[2]] == pytest.approx(reached, abs=0.005)


def test_before_a_wall_its_wheels_slip_and_the_encoders_count_on():
    simulation = Simulation((1.0, 0.0, 0.0), world=ROOM, odometry_source='encoder')
    simulation.drive(0.2, 0.0, 7.5)
    robot = simulation.robot
    assert robot.ground_truth.position[0] == pytest.approx(WALL - RADIUS, abs=0.05)
    assert robot.odometry.position[0] == pytest.approx(1.5, abs=0.02)


@pytest.mark.parametrize('phase', range(12))
@pytest.mark.parametrize('speed', [0.1, -0.2])
def test_the_twist_of_odometry_is_as_smooth_as_its_pose(speed, phase):
    """Also where a message falls on the moment in which the robot tips onto its rear caster.

    Its wheels lose their grip for three steps then, and it is half as fast.
    """
    simulation = Simulation()
    simulation.run(phase / STEP_RATE)
    seen = simulation.drive(speed, 0.0, 1.0).odometry
    ways = [after.position[0] - before.position[0] for before, after in zip(seen, seen[1:])]
    assert [20.0 * way for way in ways] == pytest.approx(
        [motion.linear[0] for motion in seen[1:]], abs=0.002)


@pytest.mark.parametrize('turn_speed', [0.5, -1.5])
def test_a_spin_turns_as_far_as_commanded_on_the_spot(turn_speed):
    """0.3 % of the angle, and the middle between the wheels stays within 2 mm."""
    simulation = Simulation()
    start = simulation.robot.ground_truth
    spin = simulation.drive(0.0, turn_speed, 20.0).ground_truth
    spin += simulation.drive(0.0, 0.0, STOPPING).ground_truth
    assert total_turn([start, *spin]) == pytest.approx(turn_speed * 20, rel=0.003)
    assert max(distance_between(start, motion) for motion in spin) <= 0.002


@pytest.mark.parametrize('source', ['world', 'encoder'])
@pytest.mark.parametrize('before', [[], [(-0.3, 0.8), (0.7, 3.0), (0.0, 0.0)]])
def test_at_rest_for_ten_minutes_it_does_not_creep(before, source):
    """On arrival and after driving: the odometry is constant to the last bit."""
    simulation = Simulation(odometry_source=source)
    for twist in before:
        simulation.drive(*twist, 2.0)
    start = simulation.robot.ground_truth
    record = simulation.drive(0.0, 0.0, TEN_MINUTES)
    assert max(distance_between(start, motion) for motion in set(record.ground_truth)) <= 1e-6
    assert len(set(record.odometry)) == 1


def test_beside_a_driving_robot_a_standing_one_does_not_creep_until_it_is_pushed():
    """It knows that it is pushed; once the other one stops, it stands again, where it has been pushed to."""
    simulation = Simulation((0, 0, 0), (-3.0, 0, 0))
    simulation.drive(0.3, 0.0, 1.0)
    simulation.drive(0.0, 0.0, STOPPING)
    robot, other = simulation.robots
    start = robot.ground_truth
    other.command(0.2, 0.0)
    record = simulation.run(10.0)
    assert max(distance_between(start, motion) for motion in record.ground_truth) <= 1e-6
    assert len(set(record.odometry)) == 1
    simulation.run(10.0)
    assert distance_between(start, robot.ground_truth) > 0.1
    assert robot.odometry.position == pytest.approx(robot.ground_truth.position, abs=1e-9)
    other.command(0.0, 0.0)
    simulation.run(STOPPING)
    assert all(robot.resting for robot in simulation.robots)
    assert len(set(simulation.run(10.0).odometry)) == 1


def test_speeding_up_and_braking_are_as_fast_as_the_motors_can():
    """At most 2.9 m/s2, half a metre per second within a fifth, and nothing beyond it.

    The tall robot leans on its rear caster meanwhile, and loses a little speed by that.
    """
    simulation = Simulation()
    faster = [motion.linear[0] for motion in simulation.drive(0.5, 0.0, 1.0).ground_truth]
    slower = [motion.linear[0] for motion in simulation.drive(0.0, 0.0, 1.0).ground_truth]
    overshoot = 0.05 * 0.5
    for number, (gained, left) in enumerate(zip(faster, slower), 1):
        change = min(0.5, 2.9 * number / STEP_RATE)
        assert gained <= change + overshoot
        assert left >= 0.5 - change - overshoot
    fifth = STEP_RATE // 5
    assert (faster[fifth], slower[fifth]) == pytest.approx((0.5, 0.0), abs=0.01)


@pytest.mark.parametrize('gyro, bound', [(False, 0.001), (True, 0.0005)])
def test_encoders_find_the_way_round_a_square(gyro, bound):
    """Four metres and four corners: a millimetre, and half of it with a gyro."""
    simulation = Simulation(odometry_source='encoder', gyro=gyro)
    for _ in range(4):
        for twist in [(0.25, 0.0, 4.0), (0.0, 0.0, 0.5), (0.0, 1.0, math.pi / 2), (0.0, 0.0, 0.5)]:
            simulation.drive(*twist)
    truth, odometry = simulation.robot.ground_truth, simulation.robot.odometry
    assert distance_between(truth, odometry) <= bound
    yaw_error = math.remainder(yaw_of(truth.orientation) - yaw_of(odometry.orientation), math.tau)
    assert abs(math.degrees(yaw_error)) <= (0.001 if gyro else 0.1)
