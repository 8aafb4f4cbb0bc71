"""Decide how fast to turn, from the heading."""

import math

from odometry_common.angles import wrap_to_pi
from odometry_common.parameters import ANY, Parameter, Parameters, Range, above, between

PARAMETERS = Parameters(
    Parameter('~target', 90.0, 'degrees', ANY, 'heading to turn to, in the odom frame'),
    Parameter('~kp', 0.5, '1/s', above(0), 'gain'),
    Parameter('~rate', 10.0, 'Hz', between(0.1, 1000), 'control rate'),
    Parameter('~max_angular_speed', 3.14, 'rad/s', above(0), 'the command is clamped to this'),
    Parameter('~tolerance', 0.0, 'degrees',
              Range('from 0 to below 180', lambda value, _: 0 <= value < 180),
              'exit once the robot is at rest this close to the target; 0: never'),
    Parameter('~timeout', 1.0, 's', between(0, 3600),
              'stop and warn while no odometry arrives for this long (ROS time, and at least 0.2 s '
              'of wall time); 0: never'))


class Turn:
    """A P-controller on the heading."""

    def __init__(self, target, kp, max_angular_speed):
        """Turn to `target` (degrees) with the gain `kp` (1/s), at most at a speed (rad/s)."""
        self.target = target
        self.kp = kp
        self.max_angular_speed = max_angular_speed

    def error_at(self, yaw):
        """Return the angle (rad) from a yaw (rad) to the target, the shorter way."""
        return wrap_to_pi(math.radians(self.target) - yaw)

    def speed_for(self, error):
        """Return the angular speed (rad/s) to command for an error (rad)."""
        return max(-self.max_angular_speed, min(self.max_angular_speed, self.kp * error))
