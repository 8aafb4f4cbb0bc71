"""UMBmark finds again the errors of a robot's odometry, and its corrections end them.

J. Borenstein and L. Feng, Measurement and correction of systematic odometry errors in mobile robots,
IEEE Transactions on Robotics and Automation 12(6), 1996. The formulas are of first order: corrected
once, the robot is measured again.
"""

import functools
import math
import statistics

import pytest
from odometry_common.geometry import wrap_to_pi, yaw_of
from odometry_common.kobuki import WHEEL_SEPARATION

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

    def __init__(self, way):
        """Begin with the first side."""
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


@pytest.fixture(autouse=True)
def squares(monkeypatch):
    """Have the sweep's loop drive squares both ways."""
    for name, way in WAYS.items():
        monkeypatch.setitem(closed_loop.TUTORIALS, name, functools.partial(Square, way))


def measure(parameters):
    """Return E_d and E_b of a robot with these parameters by UMBmark's formulas."""
    cw, ccw = ([run[axis] for axis in 'xy'] for run in (
        closed_loop.run(way, {**ROBOT, **parameters}) for way in WAYS))
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


def about(diameters, separation):
    """Return what equals E_d and E_b; PyBullet's wheels slip by up to 0.2 % in a turn."""
    return pytest.approx(diameters, abs=0.0003, rel=0), pytest.approx(separation, abs=0.003, rel=0)


@pytest.mark.parametrize('diameters, separation, gyro', [(1.003, 1.03, 0.012), (0.998, 0.985, -0.01)])
def test_errors_that_are_put_in_are_found_again_and_corrected(diameters, separation, gyro):
    """With the gyro, its scale is found in place of E_b."""
    errors = {'wheel_diameter_ratio': diameters, 'wheel_separation_ratio': separation, 'gyro': False}
    found = measure(errors)
    assert found == about(diameters, separation)
    corrected = {**errors, **corrections(*found)}
    assert measure(corrected) == about(1.0, 1.0)
    _, scale = measure({**corrected, 'gyro': True, 'gyro_scale_error': gyro})
    assert scale == pytest.approx(1 + gyro, abs=0.05 * abs(gyro), rel=0)
