"""The angular speed to command at a heading."""

import math

from odometry_common.geometry import wrap_to_pi


class Turn:
    """A P-controller on the heading."""

    def __init__(self, target, kp, max_angular_speed):
        """Turn to `target` (degrees) with the gain `kp` (1/s), within a speed (rad/s)."""
        self.target = target
        self.kp = kp
        self.max_angular_speed = max_angular_speed

    def error_at(self, yaw):
        """Return the angle (rad) from a yaw (rad) to the target, the shorter way round."""
        return wrap_to_pi(math.radians(self.target) - yaw)

    def speed_for(self, error):
        """Return the angular speed (rad/s) to command for an error (rad)."""
        return max(-self.max_angular_speed, min(self.max_angular_speed, self.kp * error))
