"""The node's parameters, read and checked."""

import math
from types import SimpleNamespace

from odometry_common.kobuki import CMD_VEL_TIMEOUT
from odometry_common.parameters import (
    ParameterError,
    get_choice,
    get_flag,
    get_number,
    get_text,
    get_whole,
)

from sim_turtlebot.poses import COORDINATES, MAX_COORDINATE


def read_settings():
    """Return all parameters by their names; raise ParameterError for the first unusable one."""
    odom_rate = get_number('~odom_rate', 20.0, lambda v: 0.1 <= v <= 1000, 'from 0.1 to 1000 Hz')
    settings = SimpleNamespace(
        gui=get_flag('~gui', False),
        world=get_text('~world', ''),
        robots=get_whole('~robots', 1, 1, 1000),
        x=_get_coordinate('~x'),
        y=_get_coordinate('~y'),
        yaw=get_number('~yaw', 0.0, lambda v: abs(v) <= 2 * math.pi, 'from -2 pi to 2 pi rad'),
        seed=get_whole('~seed', 0, -2**31, 2**31 - 1),
        odom_rate=odom_rate,
        odometry_source=get_choice('~odometry_source', 'world', ['world', 'encoder']),
        gyro=get_flag('~gyro', False),
        wheel_slip=get_number('~wheel_slip', 0.0, lambda v: 0 <= v < 1, 'from 0 to below 1'),
        wheel_noise=get_number('~wheel_noise', 0.0, lambda v: 0 <= v <= 1, 'from 0 to 1 m'),
        gyro_noise=get_number('~gyro_noise', 0.0, lambda v: 0 <= v <= 1, 'from 0 to 1 rad'),
        cmd_vel_timeout=get_number(
            '~cmd_vel_timeout', CMD_VEL_TIMEOUT, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s'),
        real_time_factor=get_number(
            '~real_time_factor', 1.0, lambda v: v == 0 or 0.001 <= v <= 1000,
            '0 (as fast as possible) or from 0.001 to 1000'),
        lockstep_rate=get_number(
            '~lockstep_rate', 0.0, lambda v: v == 0 or 0.1 <= v <= odom_rate,
            f'0 (off) or from 0.1 Hz to ~odom_rate, {odom_rate:g} Hz'),
        lockstep_patience=get_number(
            '~lockstep_patience', 2.0, lambda v: 0.1 <= v <= 3600, 'from 0.1 to 3600 s'),
        use_sim_time=get_flag('/use_sim_time', False))
    _check_wall_time(settings)
    return settings


def _get_coordinate(name):
    return get_number(name, 0.0, lambda v: abs(v) <= MAX_COORDINATE, COORDINATES)


def _check_wall_time(settings):
    """Refuse what would make wall-clock stamps lie about the speed."""
    for name, needed in (('real_time_factor', 1), ('lockstep_rate', 0)):
        value = getattr(settings, name)
        if value != needed and not settings.use_sim_time:
            raise ParameterError(f'~{name}', value, f'{needed} unless /use_sim_time is true')
