"""The parameters of the drive, read and checked."""

from odometry_common.parameters import get_flag, get_number

from straight_drive.drive import Drive


def read_drive():
    """Return the Drive that the parameters ask for."""
    return Drive(
        distance=get_number('~distance', 2.0, lambda v: v > 0, 'a number of metres above 0'),
        speed=get_number('~speed', 0.1, lambda v: v != 0, 'a speed in m/s other than 0'),
        relative=get_flag('~relative', False))
