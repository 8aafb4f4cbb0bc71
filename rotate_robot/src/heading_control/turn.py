"""Decide how fast to turn, from the heading."""

import math

from odometry_common.angles import wrap_to_pi
from odometry_common.parameters import Parameter, Parameters

PARAMETERS = Parameters(
    Parameter('~target', 90.0, 'heading to turn to, in the odom frame', 'degrees'),
    Parameter('~kp', 0.5, 'gain', '1/s', 'above 0'),
    Parameter('~rate', 10.0, 'control rate', 'Hz', 'from 0.1 to 1000'),
    Parameter('~max_angular_speed', 3.14, 'the command is clamped to this', 'rad/s', 'above 0'),
    Parameter('~tolerance', 0.0,
              'exit once the robot is at rest this close to the target; 0: never',
              'degrees', 'from 0 to below 180'),
    Parameter('~timeout', 1.0,
              'stop and warn while no odometry arrives for this long (ROS time, and at least 0.2 s '
              'of wall time); 0: never', 's', 'from 0 to 3600'))


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
