"""The simulator's parameters."""

import os

from odometry_common.parameters import Parameter, ParameterError, Parameters

from sim_turtlebot.kobuki import CMD_VEL_TIMEOUT
from sim_turtlebot.robot.poses import COORDINATES

LOCKSTEP_CLOCK_RATE = 100.0  # Hz; in lockstep a rospy.Rate of up to this keeps its rate
CLOCK_RATE = 200.0  # Hz; a client that sleeps for 0.01 s sleeps just that long
MAX_TICKS = 1000.0  # per second of wall time; more would keep clients busy with the clock alone

FROM_0_TO_1 = 'from 0 to 1'
FACTOR = 'from 0.5 to 2'
START = 'start position; odom is zero there'
SEED = Parameter('~seed', 0, 'for the noise; read at the start and at a reset', '',
                 'from -2147483648 to 2147483647')

PARAMETERS = Parameters(
    Parameter('~gui', False, "open PyBullet's window"),
    Parameter('~world', '', 'URDF or SDF file to load beside the floor'),
    Parameter('~robots', 1,
              'of several, robot k is in namespace robot_k '
              'and starts one metre left of the one before', '', 'from 1 to 1000'),
    Parameter('~x', 0.0, START, 'm', COORDINATES),
    Parameter('~y', 0.0, START, 'm', COORDINATES),
    Parameter('~yaw', 0.0, 'start heading', 'rad', 'from -2 pi to 2 pi'),
    Parameter('~odom_rate', 20.0,
              'odometry messages per simulated second', 'Hz', 'from 0.1 to 1000'),
    Parameter('~clock_rate', 0.0,
              'ticks of /clock, rounded up to a multiple of ~odom_rate; '
              '0: 200 (at most about 1000 per second of wall time), '
              'in lockstep 100, else unpaced ~odom_rate, at least 20',
              'Hz', '0 or from ~odom_rate to 1000'),
    Parameter('~publish_tf', True,
              'publish odom -> base_footprint on /tf; false where a filter does'),
    Parameter('~odometry_source', 'world',
              'world: the true pose; encoder: wheel ticks', '', 'world or encoder'),
    Parameter('~gyro', True, 'encoder: yaw from the gyro, as on a Kobuki, not from the wheels'),
    Parameter('~wheel_slip', 0.0,
              "encoder: lost share of the wheels' travel", '', 'from 0 to below 1'),
    Parameter('~wheel_noise', 0.0,
              "encoder: standard deviation of a wheel's travel after one metre", 'm', FROM_0_TO_1),
    Parameter('~gyro_noise', 0.0,
              "standard deviation of the gyro's yaw after one second", 'rad', FROM_0_TO_1),
    Parameter('~gyro_drift', 0.0, 'bias of the gyro, also at rest', 'rad/s', 'from -1 to 1'),
    Parameter('~wheel_diameter_ratio', 1.0,
              "E_d of UMBmark: the right wheel's diameter over the left's; "
              'the driver assumes their mean', '', FACTOR),
    Parameter('~wheel_separation_ratio', 1.0,
              "E_b of UMBmark: true distance between the wheels over the driver's", '', FACTOR),
    Parameter('~gyro_scale_error', 0.0,
              "relative error of the gyro's rate", '', 'from -0.5 to 0.5'),
    Parameter('~left_wheel_radius_multiplier', 1.0,
              "the driver's correction, as diff_drive_controller's", '', FACTOR),
    Parameter('~right_wheel_radius_multiplier', 1.0,
              "the driver's correction, as diff_drive_controller's", '', FACTOR),
    Parameter('~wheel_separation_multiplier', 1.0,
              "the driver's correction, as diff_drive_controller's", '', FACTOR),
    Parameter('~gyro_scale_correction', 1.0,
              "the driver's correction, as turtlebot_node's", '', FACTOR),
    Parameter('~speed_ratio', 1.0,
              'share of the commanded speed that the base really reaches',
              '', 'above 0 and up to 1'),
    Parameter('~scan', False, 'publish scans'),
    # Rate and beams of turtlebot_description's camera in Gazebo (turtlebot_gazebo.urdf.xacro).
    Parameter('~scan_rate', 10.0,
              'scans per simulated second, at most ~odom_rate', 'Hz', 'from 0.1 to 1000'),
    Parameter('~scan_beams', 640, 'ranges in a scan', '', 'from 2 to 10000'),
    # 60.2 degrees. The camera in Gazebo has 60, the data sheet of the Asus Xtion Pro 58. The margin
    # is for clients that count 30 degrees in beams to each side, and round up.
    Parameter('~scan_fov', 1.05,
              'angle from the first beam to the last', 'rad', 'from 0.01 to 2 pi'),
    # turtlebot_bringup/launch/3dsensor.launch, and the default of depthimage_to_laserscan.
    Parameter('~scan_range_min', 0.45, 'closer objects give -inf', 'm', 'from 0 to 100'),
    Parameter('~scan_range_max', 10.0,
              'farther objects give +inf', 'm', 'above ~scan_range_min and up to 1000'),
    Parameter('~scan_noise', 0.0, 'standard deviation of a range', 'm', FROM_0_TO_1),
    SEED,
    Parameter('~cmd_vel_timeout', CMD_VEL_TIMEOUT,
              'stop this long after the last command; 0: never', 's', 'from 0 to 3600'),
    Parameter('~real_time_factor', 1.0,
              'simulated seconds per second; 0: as fast as possible',
              '', '0 or from 0.001 to 1000'),
    Parameter('~lockstep', False,
              'time waits until every node on this machine has finished its work'),
    # With 80 particles gmapping computes for more than two seconds.
    Parameter('~cpu_budget', 20.0,
              'lockstep: CPU time after which a busy node is no longer awaited',
              's', 'from 0.1 to 3600'),
    Parameter('~paused', False, 'time begins with ~unpause_physics'))
USE_SIM_TIME = Parameters(Parameter('/use_sim_time', False, 'stamps are simulated time'))


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
    for name, needed, text in (('real_time_factor', 1, '1'), ('lockstep', False, 'false')):
        value = getattr(settings, name)
        if value != needed and not settings.use_sim_time:
            raise ParameterError(f'~{name}', value, f'{text} unless /use_sim_time is true')
