"""The wheel geometry that the base driver assumes."""

from sim_turtlebot.kobuki import WHEEL_SEPARATION


class DriveGeometry:
    """The wheel geometry that the driver assumes; the URDF has the true one.

    The driver converts commands to wheel speeds, and wheel travel to odometry, by the same numbers:
    a Kobuki's are built into its firmware and its driver (kobuki_driver/src/driver/diff_drive.cpp).
    A wrong value bends the true path, and the wheels' odometry does not show it (Borenstein and
    Feng, Measurement and correction of systematic odometry errors in mobile robots, IEEE
    Transactions on Robotics and Automation 12(6), 1996).
    """

    def __init__(self, settings):
        """Take the settings of sim_turtlebot.settings.read_settings().

        With E_d = D_right / D_left and the mean diameter kept, UMBmark gives D_left = 2 / (E_d + 1)
        and D_right = 2 / (1 / E_d + 1) of the diameter that the driver assumes for both.
        """
        diameters = settings.wheel_diameter_ratio
        # The assumed radius of each wheel, divided by the true one; the distance between them (m).
        self._left = settings.left_wheel_radius_multiplier * (diameters + 1) / 2
        self._right = settings.right_wheel_radius_multiplier * (1 / diameters + 1) / 2
        self._separation = (settings.wheel_separation_multiplier * WHEEL_SEPARATION
                            / settings.wheel_separation_ratio)
        self._speed_ratio = settings.speed_ratio  # which the encoders show

    def wheel_speeds(self, linear, angular):
        """Return the true speeds (m/s) of the left and right rim for a command (m/s, rad/s)."""
        linear = self._speed_ratio * linear
        difference = self._speed_ratio * angular * self._separation / 2
        return (linear - difference) / self._left, (linear + difference) / self._right

    def motion(self, left, right):
        """Return the assumed travel (m) and rotation (rad) for the true roll of each wheel (m)."""
        left, right = self._left * left, self._right * right
        return (left + right) / 2, (right - left) / self._separation
