"""The detector's parameters, read and checked."""

from odometry_common.parameters import get_number

from moved_distance.distance_counter import DistanceCounter


def read_counter():
    """Return the DistanceCounter that the parameters ask for."""
    return DistanceCounter(
        min_step=get_number('~min_step', 0.0, lambda v: v >= 0, 'a number of metres from 0'),
        max_speed=get_number('~max_speed', 5.0, lambda v: v >= 0, 'a speed in m/s from 0'))
