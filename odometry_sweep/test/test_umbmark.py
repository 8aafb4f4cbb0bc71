"""UMBmark finds again the errors of a robot's odometry, and its corrections end them.

J. Borenstein and L. Feng, Measurement and correction of systematic odometry errors in mobile robots,
IEEE Transactions on Robotics and Automation 12(6), 1996. The formulas are of first order: corrected
once, the robot is measured again.
"""

import functools
import math
import random
import statistics

import pytest
from odometry_common.geometry import wrap_to_pi, yaw_of
from odometry_common.kobuki import WHEEL_RADIUS, WHEEL_SEPARATION
from odometry_tests.arcs import Body, motion, on_arc

from odometry_sweep import closed_loop

SIDE = 4.0  # m
SPEED, SLOW = 0.5, 0.02  # m/s; on a side, and at its end
BRAKING, GAIN = 4.0, 4.0  # 1/s
SHARP = math.radians(0.1)  # heading error that is left alone
WAYS = {'cw': -1, 'ccw': 1}
ROBOT = {'odometry_source': 'encoder', 'odom_rate': 10}


class Square:
    """Drives a square by its odometry, around to the left (1) or to the right (-1)."""

    longest = 100.0  # s

    def __init__(self, way, _values):
        self._way = way
        self._corners = [(SIDE, 0.0), (SIDE, way * SIDE), (0.0, way * SIDE), (0.0, 0.0)]
        self._side, self._turns = 0, False

    def answer(self, _stamp, odometry, _ground_truth):
        """Return the command, and whether the square is complete."""
        self._believed = odometry.position
        heading = self._way * self._side * math.pi / 2
        error = wrap_to_pi(heading - yaw_of(odometry.orientation))
        turn_speed = GAIN * error if abs(error) > SHARP else 0.0
        self._turns = self._turns and turn_speed != 0
        if self._turns:
            return (0.0, turn_speed), False
        x, y = (end - here for end, here in zip(self._corners[self._side], self._believed))
        ahead = x * math.cos(heading) + y * math.sin(heading)
        if ahead > 0:
            return (min(SPEED, SLOW + BRAKING * ahead), turn_speed), False
        self._side, self._turns = self._side + 1, True
        return (0.0, 0.0), self._side == len(self._corners)

    def metrics(self, _start, end):
        """Return how far the robot is from where its odometry says (m)."""
        return {axis: true - believed
                for axis, true, believed in zip('xy', end.position, self._believed)}


class RollingBody(Body):
    """A body on wheels that roll without slip, in closed form."""

    rims = 0.0, 0.0  # m/s

    def drive(self, left, right):
        """Turn the wheels so that their rims move at these speeds (m/s)."""
        self.rims = left, right

    def roll(self, time):
        """Move for so long (s)."""
        left, right = self.rims
        speed, turn_speed = (left + right) / 2, (right - left) / WHEEL_SEPARATION
        (here_x, here_y, _), here_yaw = self.motion.position, yaw_of(self.motion.orientation)
        x, y, yaw = on_arc(speed, turn_speed, time)
        cos, sin = math.cos(here_yaw), math.sin(here_yaw)
        self.motion = motion(here_x + cos * x - sin * y, here_y + sin * x + cos * y, here_yaw + yaw,
                             (speed, 0.0, 0.0), (0.0, 0.0, turn_speed))
        self.angles = tuple(angle + rim * time / WHEEL_RADIUS
                            for angle, rim in zip(self.angles, self.rims))


class RollingWorld:
    """A world with a RollingBody, in place of PyBullet's."""

    only_robots_move = True

    def __init__(self, step_rate, *_):
        """Build it; parameters as those of sim_turtlebot.physics.World."""
        self._step_rate = step_rate
        self.robots = [RollingBody()]

    def step(self, steps=1):
        """Let 1/step_rate seconds pass `steps` times."""
        self.robots[0].roll(steps / self._step_rate)


@pytest.fixture(autouse=True)
def squares(monkeypatch):
    """Have the sweep's loop drive squares both ways."""
    for name, way in WAYS.items():
        monkeypatch.setitem(closed_loop.TUTORIALS, name, functools.partial(Square, way))


def measure(parameters, build_world=RollingWorld, seeds=1):
    """Return E_d and E_b of a robot with these parameters by UMBmark's formulas."""
    runs = {way: [closed_loop.run(way, {**ROBOT, 'seed': seed, **parameters}, build_world)
                  for seed in range(seeds)] for way in WAYS}
    cw, ccw = ([statistics.mean(run[axis] for run in runs[way]) for axis in 'xy'] for way in WAYS)
    alpha = statistics.mean([cw[0] + ccw[0], cw[1] - ccw[1]]) / (-4 * SIDE)
    beta = statistics.mean([cw[0] - ccw[0], cw[1] + ccw[1]]) / (-4 * SIDE)
    radius = SIDE / 2 / math.sin(beta / 2)
    return ((radius + WHEEL_SEPARATION / 2) / (radius - WHEEL_SEPARATION / 2),
            math.radians(90) / (math.radians(90) - alpha))


def corrections(diameters, separation):
    """Return the parameters of the driver that correct an E_d and an E_b."""
    return {'left_wheel_radius_multiplier': 2 / (diameters + 1),
            'right_wheel_radius_multiplier': 2 / (1 / diameters + 1),
            'wheel_separation_multiplier': separation}


def measure_twice(errors, **world):
    """Return E_d and E_b after a second measurement, with the corrections of the first."""
    first = measure(errors, **world)
    second = measure({**errors, **corrections(*first)}, **world)
    return [one * two for one, two in zip(first, second)]


def draw(rng, size):
    """Return an error of a third of this size to all of it, to either side."""
    return rng.choice([-1, 1]) * rng.uniform(size / 3, size)


@pytest.mark.parametrize('seed', [
    0, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(1, 10))])
def test_errors_that_are_put_in_are_found_again(seed):
    """Within 5 % of each of 100 triples, ten with each seed: E_d, E_b, and with the gyro its scale in place of E_b."""
    rng = random.Random(seed)
    for _ in range(10):
        diameters, separation, gyro = (draw(rng, size) for size in (0.003, 0.02, 0.015))
        errors = {'wheel_diameter_ratio': 1 + diameters, 'wheel_separation_ratio': 1 + separation,
                  'gyro_scale_error': gyro}
        found = measure_twice({**errors, 'gyro': False})
        assert found == [pytest.approx(1 + error, abs=0.05 * abs(error), rel=0)
                         for error in (diameters, separation)], errors
        _, scale = measure({**errors, **corrections(*found)})
        assert scale == pytest.approx(1 + gyro, abs=0.05 * abs(gyro), rel=0), errors


@pytest.mark.nightly
def test_the_physics_say_the_same_with_noise_over_five_squares_each_way():
    """Within 10 %: PyBullet's wheels also slip a little in a turn, by 0.1 to 0.2 % of it."""
    errors = {'wheel_diameter_ratio': 1.003, 'wheel_separation_ratio': 1.03, 'gyro': False,
              'wheel_noise': 0.0002}
    found = measure(errors, build_world=None, seeds=5)
    assert found == (pytest.approx(1.003, abs=0.0003, rel=0), pytest.approx(1.03, abs=0.003, rel=0))
