"""Hints that a motion or a count proves: it fits one mistake and no other, or compares two runs."""

import math

from odometry_tools.check.rule import Rule
from odometry_tools.check.scenarios import SLOW, TARGET

YAW, MINUS = ('yaw', 'yaw_to_360'), ('minus_yaw', 'minus_wrapped')
SAME_ANGLE = 5.0  # degrees
BOTH_WAYS = 10.0  # degrees by which the longer and the shorter way may differ from a whole turn
BEHIND, NEAR = 135.0, 45.0  # degrees from the target where the robot swings
# Degrees, if the target or the yaw has the wrong unit.
DEGREES, RADIANS = 57.29578 * TARGET, TARGET / 57.29578


def _fits(*names):
    """Return a test: whether these are the only fit of a detector that holds in all scenarios."""
    return lambda m: len(m.common_fits) == 1 and {name for name, _ in m.common_fits} <= {*names}


def _is_nearest(name):
    """Return a test: whether a place fits one mistake only, and `plain` passes."""
    return lambda m: _is_only_here(m) and m.scenario.name == 'moved_start' and m.fits == {name}


def _has_wrong_sign(m):
    return m.follows in MINUS and abs(m.zero + TARGET) < SAME_ANGLE


def _aims_at_90(m):
    """Return whether its commands follow the heading, and are zero at 90 degrees."""
    return m.follows in YAW and abs(m.zero - TARGET) < SAME_ANGLE


def _chatters(m):
    """Return whether its speed has one size; one that is clamped here has others in `plain`."""
    return m.rule == 'rings' and m.chatter and m.plain and m.plain.chatter == m.chatter


def _rests_at_radians(m):
    return (m.rule == 'elsewhere' and abs(m.heading - RADIANS) < 0.1
            and (m.same_heading or abs(m.start_heading) > SAME_ANGLE))


def _is_only_here(m):
    """Return whether this scenario fails and the first one passes."""
    return m.plain is not None and m.plain.passed and not m.passed


def _is_as_slow(m):
    """Return whether the drive, or the turn, is 70 % of that in `plain`."""
    pairs = (m.share, m.plain.share), (m.net, m.plain.net)
    return any(before and abs(now / before - SLOW) < 0.02 for now, before in pairs)


def _is_open_loop(m):
    """Return whether the slow base alone explains where the robot rests, or what was counted."""
    explains = {
        'early': True,
        'elsewhere': True,
        'ceased': m.plain.was_there,
        'miscounted': m.plain.passed}
    return explains.get(m.rule) and _is_as_slow(m)


def _counts_as(m, other):
    """Return whether a detector counted the same share of the way as in another scenario."""
    return abs(m.share - other.share) < 0.02


PLACES = (
    Rule('one_axis', _is_nearest('one_axis'),
         '{moved_x:.2f} m are along x and {moved_y:.2f} along y: one axis alone counts. '
         'Take math.hypot(dx, dy)'),
    Rule('sum_of_axes', _is_nearest('sum_of_axes'),
         '{moved_x:.2f} m are along x and {moved_y:.2f} along y, 2 in sum: '
         'take math.hypot(dx, dy)'),
    Rule('place', _is_nearest('place'),
         'That is at the point (2, 0) of odometry: store where you start, and count from there'))
ANGLES = (
    Rule('degrees', lambda m: m.follows == 'yaw' and abs(m.zero - DEGREES) < TARGET,
         'Your commands are 90 minus the yaw in radians: take math.radians(90)'),
    Rule('radians', _rests_at_radians,
         'Your target is 1.57 degrees, as if 90 degrees in radians were degrees: '
         'convert once, and compare like with like'),
    Rule('sign', lambda m: (_has_wrong_sign(m) or m.plain and _has_wrong_sign(m.plain)
                           or _chatters(m) and m.heading_error > BEHIND),
         'Your commands follow yaw - target, and turn away from it: '
         'ROS turns left for positive, so error = target - yaw'),
    Rule('quaternion', lambda m: m.follows == 'quaternion',
         'Your commands follow orientation.z, which is sin(yaw / 2) and no angle: '
         'use euler_from_quaternion'),
    Rule('half_circle', lambda m: m.follows == 'half_circle',
         'Your commands follow the error without its sign, as from asin() or abs(): '
         'use euler_from_quaternion, and keep the sign'),
    Rule('longer_way', lambda m: (m.rule == 'long_way' and not m.is_short
                                 and m.turned - abs(m.net) < BOTH_WAYS
                                 and abs(abs(m.net) + m.shortest - 360) < BOTH_WAYS),
         'That is the longer way round: wrap the error, for example by atan2(sin(e), cos(e)), '
         'and turn by its sign'),
    Rule('gain_low', lambda m: m.rule == 'unfinished' and _aims_at_90(m) and 0 < m.gain < 0.05,
         'You turn at {gain:.3f} rad/s for each radian of error, by which it takes minutes: '
         'try 0.5'),
    Rule('gain_high', lambda m: m.rule in ('rings', 'long_way') and _aims_at_90(m) and m.gain > 2,
         'You turn at {gain:.1f} rad/s for each radian of error: lower that towards 0.5'),
    Rule('chatter', lambda m: _chatters(m) and m.heading_error < NEAR,
         'From the first change on it was {chatter:.2g} rad/s, or minus that: '
         'make it proportional to the error, or stop within a tolerance'),
    # From heading 0 a turn by 90 degrees is one to 90.
    Rule('turns_by', lambda m: (m.turns_by and not m.run.is_driving
                                and abs(m.start_heading) > SAME_ANGLE),
         'You turn by {net:.0f} degrees, as in {plain.scenario.name} from another heading; '
         'the exercise asks for heading 90 in the odom frame'))
SUMS = (
    Rule('from_origin', _fits('origin', 'first_step'),
         'Before the robot moved you published {offset:.2f} m: '
         'take the first message as the start'),
    Rule('one_axis', _fits('x_only', 'y_only', 'signed_x'),
         'That is the way along one axis: take math.hypot(dx, dy)'),
    Rule('sum_of_axes', _fits('axes', 'signed_axes'),
         'That is the sum of dx and dy: take math.hypot(dx, dy)'),
    Rule('rounded', _fits('rounded_1', 'rounded_2'),
         'That is the way between rounded positions: round when you print, not before you add'),
    Rule('squares', _fits('squares'), 'That is the sum of squares: take the square root'),
    Rule('fixed_dt', _fits('signed_speed', 'speed'),
         'That is speed times a fixed {factor:g} s for each message: '
         'take the time from the stamps, or positions; driving back use abs()'),
    Rule('backwards', _fits('backwards'),
         'Your sum falls while the robot drives back: use abs(), or math.hypot(dx, dy)'),
    Rule('displacements', _fits('displacements'),
         'You add the distance from the start at each message: '
         'store each position, and count from it to the next'),
    Rule('times', _fits('times'),
         'That is {factor:g} times the way, on each leg and at each rate'),
    Rule('last_step', lambda m: (m.rule == 'miscounted'
                                 and math.isclose(m.largest, m.largest_step, rel_tol=0.1)),
         'You published at most {largest:.3f} m, the size of one step: add each to the sum so far'),
    Rule('falls', lambda m: m.rule == 'miscounted' and m.fell_from - m.fell_to > 0.05,
         'You published {fell_from:.2f} m and then {fell_to:.2f}: a distance moved never falls'))
COMPARED = (
    Rule('open_loop', lambda m: m.scenario.name == 'slow_base' and m.plain and _is_open_loop(m),
         'This base reaches 70 % of your speed, and so does your result: '
         'count odometry, not time or commands'),
    Rule('slow_odometry', lambda m: (m.fails_alone and m.rate < 20
                                     and m.rule in ('passed_by', 'drove_on', 'rings', 'long_way')),
         'With odometry 20 times a second it is right; here one message is a step of up to '
         '{step:.2f} {unit}. Look for a window narrower than that, a high gain, '
         'a filter, or a fixed time for each message'),
    Rule('start', lambda m: (_is_only_here(m) and m.scenario.name == 'moved_start'
                             and m.rule not in m.rules_at_start
                             and not (m.exercise.route and _counts_as(m, m.plain))),
         'In {plain.scenario.name} it is right: the result depends on where the robot starts'))
