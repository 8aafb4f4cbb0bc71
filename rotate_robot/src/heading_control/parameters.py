"""The parameters of rotate.py's controller, read and checked."""

from odometry_common.parameters import get_number

from heading_control.turn import Turn


def read_turn():
    """Return the Turn that the parameters ask for."""
    return Turn(
        target=get_number('~target', 90.0, allowed='a finite number of degrees'),
        kp=get_number('~kp', 0.5, lambda v: v > 0, 'a gain in 1/s above 0'),
        max_angular_speed=get_number(
            '~max_angular_speed', 3.14, lambda v: v > 0, 'a speed in rad/s above 0'))


def read_rate():
    """Return the control rate (Hz)."""
    return get_number('~rate', 10.0, lambda v: 0.1 <= v <= 1000, 'from 0.1 to 1000 Hz')
