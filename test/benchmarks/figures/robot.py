"""The simulator's robot without ROS, commanded after each odometry, beside PyBullet alone."""

from measuring import SPEED_UNIT, Target, in_slices
from worlds import BareWorld, RobotWorld

NAME, UNIT, TARGET = 'robot without ROS', SPEED_UNIT, Target('>=', 0.85)


def measure(options):
    return in_slices(options, RobotWorld().speed, BareWorld().speed)
