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

from sim_turtlebot import scanner
from sim_turtlebot.poses import COORDINATES, MAX_COORDINATE

LOCKSTEP_CLOCK_RATE = 100.0  # Hz; in lockstep a rospy.Rate of up to this keeps its rate
CLOCK_RATE = 200.0  # Hz; a client that sleeps for a hundredth of a second gets just that
MOST_TICKS = 1000.0  # per second of wall time; more keep a client busy with nothing but the clock


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
        clock_rate=get_number(
            '~clock_rate', 0.0, lambda v: v == 0 or odom_rate <= v <= 1000,
            f'0 (by default) or from ~odom_rate ({odom_rate:g} Hz) to 1000 Hz'),
        odometry_source=get_choice('~odometry_source', 'world', ['world', 'encoder']),
        gyro=get_flag('~gyro', True),
        wheel_slip=get_number('~wheel_slip', 0.0, lambda v: 0 <= v < 1, 'from 0 to below 1'),
        wheel_noise=get_number('~wheel_noise', 0.0, lambda v: 0 <= v <= 1, 'from 0 to 1 m'),
        gyro_noise=get_number('~gyro_noise', 0.0, lambda v: 0 <= v <= 1, 'from 0 to 1 rad'),
        gyro_drift=get_number(
            '~gyro_drift', 0.0, lambda v: abs(v) <= 1, 'from -1 to 1 rad/s'),
        cmd_vel_timeout=get_number(
            '~cmd_vel_timeout', CMD_VEL_TIMEOUT, lambda v: 0 <= v <= 3600, 'from 0 to 3600 s'),
        real_time_factor=get_number(
            '~real_time_factor', 1.0, lambda v: v == 0 or 0.001 <= v <= 1000,
            '0 (as fast as possible) or from 0.001 to 1000'),
        lockstep=get_flag('~lockstep', False),
        paused=get_flag('~paused', False),
        use_sim_time=get_flag('/use_sim_time', False),
        **_read_scan(odom_rate))
    _check_wall_time(settings)
    settings.clock_rate = settings.clock_rate or _default_clock_rate(settings)
    return settings


def _read_scan(odom_rate):
    range_min = get_number(
        '~scan_range_min', scanner.RANGE_MIN, lambda v: 0 <= v <= 100, 'from 0 to 100 m')
    return {
        'scan': get_flag('~scan', False),
        'scan_rate': get_number(
            '~scan_rate', min(scanner.RATE, odom_rate), lambda v: 0.1 <= v <= odom_rate,
            f'from 0.1 to ~odom_rate, {odom_rate:g} Hz'),
        'scan_beams': get_whole('~scan_beams', scanner.BEAMS, 2, 10000),
        'scan_fov': get_number('~scan_fov', scanner.FIELD_OF_VIEW,
                               lambda v: 0.01 <= v <= 2 * math.pi, 'from 0.01 to 2 pi rad'),
        'scan_range_min': range_min,
        'scan_range_max': get_number(
            '~scan_range_max', scanner.RANGE_MAX, lambda v: range_min < v <= 1000,
            'above ~scan_range_min and up to 1000 m'),
        'scan_noise': get_number('~scan_noise', 0.0, lambda v: 0 <= v <= 1, 'from 0 to 1 m')}


def _get_coordinate(name):
    return get_number(name, 0.0, lambda v: abs(v) <= MAX_COORDINATE, COORDINATES)


def _default_clock_rate(settings):
    """Return the rate (Hz) that a client needs for loops of its own; 0: the coarsest.

    Where time is not paced, or not ours, more ticks would cost time and help nobody.
    """
    pace = settings.real_time_factor
    if settings.lockstep:
        return LOCKSTEP_CLOCK_RATE
    if pace == 0 or not settings.use_sim_time:
        return 0.0
    return min(CLOCK_RATE, MOST_TICKS / pace)


def _check_wall_time(settings):
    """Refuse what would make wall-clock stamps lie about the speed."""
    for name, needed in (('real_time_factor', 1), ('lockstep', False)):
        value = getattr(settings, name)
        if value != needed and not settings.use_sim_time:
            raise ParameterError(f'~{name}', value, f'{needed} unless /use_sim_time is true')
