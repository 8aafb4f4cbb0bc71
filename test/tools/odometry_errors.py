"""Print what simulated encoder odometry gets wrong: ./ws python3 test/tools/odometry_errors.py.

The table in docs/real_robot.md. Each drive is simulated once, and counted by many robots.
"""

import argparse
import math
import statistics

from odometry_common.geometry import yaw_of
from odometry_tests.arcs import Robot
from odometry_tests.simulation import Simulation

SEEDS = 200
TWO_METRES = 0.1, 0.0, 20.0  # m/s, rad/s, s
TEN_TURNS = 0.0, 0.5, 20 * math.pi / 0.5
REST = 1.0  # s
# Two degrees a minute: a Kobuki's gyro at its worst, as its maintainer says.
WORST_GYRO = round(math.radians(2.0) / math.sqrt(60.0), 4)
WORST_DRIFT = round(math.radians(2.0) / 60.0, 5)
CASES = [{}, {'gyro': False}, {'wheel_slip': 0.01}, {'wheel_noise': 0.005},
         {'gyro': False, 'wheel_noise': 0.005}, {'gyro_noise': WORST_GYRO},
         {'gyro_drift': WORST_DRIFT}, {'gyro_scale_error': 0.006},
         {'gyro': False, 'wheel_diameter_ratio': 1.005}, {'gyro': False, 'wheel_separation_ratio': 1.02}]


def main():
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    straight, turning = record(*TWO_METRES), record(*TEN_TURNS)
    for case in CASES:
        errors = [(*count(straight, case, seed), count(turning, case, seed)[1])
                  for seed in range(SEEDS)]
        parameters = ' '.join(f'`_{name}:={str(value).lower()}`' for name, value in case.items())
        print('|', ' | '.join([parameters, *map(in_words, zip(*errors))]), '|')


def in_words(errors):
    """Return mean and standard deviation; the latter only if there is one."""
    spread = statistics.stdev(errors)
    mean = round(statistics.mean(errors), 1) + 0.0
    return f'{mean} ± {spread:.1f}' if spread > 0.05 else f'{mean}'


def record(linear, angular, duration):
    """Return the true motion and the wheels' angles at each odometry of a drive and the stop after it."""
    simulation, rows = Simulation(), []
    robot, timeline = simulation.robot, simulation.timeline
    for command, end in (((linear, angular), duration), ((0.0, 0.0), duration + REST)):
        simulation.command(*command)
        while timeline.now < end * 1e9:
            if not rows or simulation.advance():
                rows.append((robot.ground_truth, robot.wheels[0]))
    return rows


def count(rows, case, seed):
    """Return by how much the odometry has counted too far (mm) and turned too far (degrees)."""
    robot = Robot(odometry_source='encoder', seed=seed, **case)
    robot.start(*rows[0])
    for true, angles in rows[1:]:
        believed = robot.move(true, angles)
    far = math.hypot(*believed.position[:2]) - math.hypot(*true.position[:2])
    turned = math.remainder(yaw_of(believed.orientation) - yaw_of(true.orientation), 2 * math.pi)
    return 1e3 * far, math.degrees(turned)


if __name__ == '__main__':
    main()
