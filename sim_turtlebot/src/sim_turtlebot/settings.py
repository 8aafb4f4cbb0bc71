"""The simulator's parameters."""

import math
import os

from odometry_common.parameters import (
    ANY,
    Parameter,
    ParameterError,
    Parameters,
    Range,
    between,
    one_of,
)

from sim_turtlebot.kobuki import CMD_VEL_TIMEOUT
from sim_turtlebot.robot.poses import MAX_COORDINATE

LOCKSTEP_CLOCK_RATE = 100.0  # Hz; in lockstep a rospy.Rate of up to this keeps its rate
CLOCK_RATE = 200.0  # Hz; a client that sleeps for 0.01 s sleeps just that long
MAX_TICKS = 1000.0  # per second of wall time; more would keep clients busy with the clock alone

FROM_0_TO_1 = between(0, 1)
FACTOR = between(0.5, 2)
COORDINATE = between(-MAX_COORDINATE, MAX_COORDINATE)
START = 'start position; odom is zero there'
SEED = Parameter('~seed', 0, '', between(-2**31, 2**31 - 1),
                 'for the noise; read at the start and at a reset')

PARAMETERS = Parameters(
    Parameter('~gui', False, '', ANY, "open PyBullet's window"),
    Parameter('~world', '', '', ANY, 'URDF or SDF file to load beside the floor'),
    Parameter('~robots', 1, '', between(1, 1000),
              'of several, robot k is in namespace robot_k '
              'and starts one metre left of the one before'),
    Parameter('~x', 0.0, 'm', COORDINATE, START),
    Parameter('~y', 0.0, 'm', COORDINATE, START),
    Parameter('~yaw', 0.0, 'rad',
              Range('from -2 pi to 2 pi', lambda value, _: abs(value) <= 2 * math.pi),
              'start heading'),
    Parameter('~odom_rate', 20.0, 'Hz', between(0.1, 1000),
              'odometry messages per simulated second'),
    Parameter('~clock_rate', 0.0, 'Hz',
              Range('0 or from ~odom_rate to 1000',
                    lambda value, earlier: value == 0 or earlier.odom_rate <= value <= 1000),
              'ticks of /clock, rounded up to a multiple of ~odom_rate; '
              '0: 200 (at most about 1000 per second of wall time), '
              'in lockstep 100, else unpaced ~odom_rate'),
    Parameter('~publish_tf', True, '', ANY,
              'publish odom -> base_footprint on /tf; false where a filter does'),
    Parameter('~odometry_source', 'world', '', one_of('world', 'encoder'),
              'world: the true pose; encoder: wheel ticks'),
    Parameter('~gyro', True, '', ANY,
              'encoder: yaw from the gyro, as on a Kobuki, not from the wheels'),
    Parameter('~wheel_slip', 0.0, '',
              Range('from 0 to below 1', lambda value, _: 0 <= value < 1),
              "encoder: lost share of the wheels' travel"),
    Parameter('~wheel_noise', 0.0, 'm', FROM_0_TO_1,
              "encoder: standard deviation of a wheel's travel after one metre"),
    Parameter('~gyro_noise', 0.0, 'rad', FROM_0_TO_1,
              "standard deviation of the gyro's yaw after one second"),
    Parameter('~gyro_drift', 0.0, 'rad/s', between(-1, 1), 'bias of the gyro, also at rest'),
    Parameter('~wheel_diameter_ratio', 1.0, '', FACTOR,
              "E_d of UMBmark: the right wheel's diameter over the left's; "
              'the driver assumes their mean'),
    Parameter('~wheel_separation_ratio', 1.0, '', FACTOR,
              "E_b of UMBmark: true distance between the wheels over the driver's"),
    Parameter('~gyro_scale_error', 0.0, '', between(-0.5, 0.5),
              "relative error of the gyro's rate"),
    Parameter('~left_wheel_radius_multiplier', 1.0, '', FACTOR,
              "the driver's correction, as diff_drive_controller's"),
    Parameter('~right_wheel_radius_multiplier', 1.0, '', FACTOR,
              "the driver's correction, as diff_drive_controller's"),
    Parameter('~wheel_separation_multiplier', 1.0, '', FACTOR,
              "the driver's correction, as diff_drive_controller's"),
    Parameter('~gyro_scale_correction', 1.0, '', FACTOR,
              "the driver's correction, as turtlebot_node's"),
    Parameter('~speed_ratio', 1.0, '',
              Range('above 0 and up to 1', lambda value, _: 0 < value <= 1),
              'share of the commanded speed that the base really reaches'),
    Parameter('~scan', False, '', ANY, 'publish scans'),
    # Rate and beams of turtlebot_description's camera in Gazebo (turtlebot_gazebo.urdf.xacro).
    Parameter('~scan_rate', 10.0, 'Hz', between(0.1, 1000),
              'scans per simulated second, at most ~odom_rate'),
    Parameter('~scan_beams', 640, '', between(2, 10000), 'ranges in a scan'),
    # 60.2 degrees. The camera in Gazebo has 60, the data sheet of the Asus Xtion Pro 58. The margin
    # is for clients that count 30 degrees in beams to each side, and round up.
    Parameter('~scan_fov', 1.05, 'rad',
              Range('from 0.01 to 2 pi', lambda value, _: 0.01 <= value <= 2 * math.pi),
              'angle from the first beam to the last'),
    # turtlebot_bringup/launch/3dsensor.launch, and the default of depthimage_to_laserscan.
    Parameter('~scan_range_min', 0.45, 'm', between(0, 100),
              'closer objects give -inf'),
    Parameter('~scan_range_max', 10.0, 'm',
              Range('above ~scan_range_min and up to 1000',
                    lambda value, earlier: earlier.scan_range_min < value <= 1000),
              'farther objects give +inf'),
    Parameter('~scan_noise', 0.0, 'm', FROM_0_TO_1, 'standard deviation of a range'),
    SEED,
    Parameter('~cmd_vel_timeout', CMD_VEL_TIMEOUT, 's', between(0, 3600),
              'stop this long after the last command; 0: never'),
    Parameter('~real_time_factor', 1.0, '',
              Range('0 or from 0.001 to 1000',
                    lambda value, _: value == 0 or 0.001 <= value <= 1000),
              'simulated seconds per second; 0: as fast as possible'),
    Parameter('~lockstep', False, '', ANY,
              'time waits until every node on this machine has finished its work'),
    # With 80 particles gmapping computes for more than two seconds.
    Parameter('~cpu_budget', 20.0, 's', between(0.1, 3600),
              'lockstep: CPU time after which a busy node is no longer awaited'),
    Parameter('~paused', False, '', ANY, 'time begins with ~unpause_physics'))
USE_SIM_TIME = Parameters(Parameter('/use_sim_time', False, '', ANY, 'stamps are simulated time'))


def read_settings(source=None):
    """Return all parameters by their names; raise ParameterError for the first wrong one.

    :param source: as for Parameters.read()
    """
    settings = PARAMETERS.read(source)
    if settings.gui and not os.environ.get('DISPLAY'):  # PyBullet would end the process
        raise ParameterError('~gui', True, 'false: no display; set DISPLAY')
    settings.use_sim_time = USE_SIM_TIME.read(source).use_sim_time
    _check_wall_time(settings)
    settings.scan_rate = min(settings.scan_rate, settings.odom_rate)
    settings.clock_rate = settings.clock_rate or _default_clock_rate(settings)
    return settings


def read_seed():
    """Return the seed that is set now; raise ParameterError if it is none."""
    return Parameters(SEED).read().seed


def _default_clock_rate(settings):
    """Return the rate (Hz) that clients need for their own loops; 0: the lowest.

    With unpaced or wall time, more ticks would only cost time.
    """
    pace = settings.real_time_factor
    if settings.lockstep:
        return LOCKSTEP_CLOCK_RATE
    if pace == 0 or not settings.use_sim_time:
        return 0.0
    return min(CLOCK_RATE, MAX_TICKS / pace)


def _check_wall_time(settings):
    """Raise ParameterError for settings with which wall-clock stamps would be wrong."""
    for name, needed in (('real_time_factor', 1), ('lockstep', False)):
        value = getattr(settings, name)
        if value != needed and not settings.use_sim_time:
            raise ParameterError(f'~{name}', value, f'{needed} unless /use_sim_time is true')
