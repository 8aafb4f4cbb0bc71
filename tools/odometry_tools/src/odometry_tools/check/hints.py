"""Hints: the cause of a failure, named only where the check saw proof of it.

Each rule looks at the graph, the output, an exit status or a fit. The two that always hold are
advice on what the verdict itself has shown.
"""

import math

from odometry_tools.check.rule import Rule, first
from odometry_tools.check.scenarios import SLOW, TARGET

UNKNOWN = 'We do not know why: print the {quantity} in your loop, and look at the picture'
YAW, MINUS = ('yaw', 'yaw_to_360'), ('minus_yaw', 'minus_wrapped')
SAME_ANGLE = 5.0  # degrees
WATCHDOG = 0.6  # s
# Degrees, if the target or the yaw has the wrong unit.
DEGREES, RADIANS = 57.29578 * TARGET, TARGET / 57.29578


def hint_for(m):
    """Return the Rule that names the cause of a failure, or None."""
    return first((*BY_VERDICT.get(m.rule, ()), *BY_EXERCISE[m.exercise.name], *COMPARED), m)


def _error_if(test):
    """Return a hint that quotes the last error, if `test`, of the measures, proves it the cause."""
    return Rule('error', lambda m: m.error and test(m), '{error}')


def _ended_with_error(m):
    return m.status == 1 or m.ends_with_error  # Python exits with 1 after an error


def _only_input_fails(m):
    """Return whether the callback that is the node's only input failed for most messages."""
    return len(m.inputs_of_robot) == 1 and m.failures > m.rate * m.run.now / 2


def _died_unnoticed(m):
    return _only_input_fails(m) or m.has_dead_thread or m.status == 0 and m.ends_with_error


def _fails_since_last_command(m):
    messages = m.rate * (m.run.now - m.commands[-1].time)
    return m.has_late_dead_thread or m.failures == m.late_failures > messages / 2


def _fits(*names):
    """Return a test: whether these are the only fit of a detector that holds in all scenarios."""
    return lambda m: len(m.common_fits) == 1 and {name for name, _ in m.common_fits} <= {*names}


def _is_nearest(name):
    """Return a test: whether a place fits one mistake only, and `plain` passes."""
    return lambda m: _is_only_here(m) and m.scenario.name == 'moved_start' and m.fits == {name}


def _has_wrong_sign(m):
    return m.follows in MINUS and abs(m.zero + TARGET) < SAME_ANGLE


def _is_only_here(m):
    """Return whether this scenario fails and the first one passes."""
    return m.plain is not None and m.plain.passed and not m.passed


KEYBOARD = Rule(
    'keyboard', lambda m: m.run.has_read_keyboard,
    'Your node reads the keyboard, which a launch file cannot offer: make the value a parameter')
NOT_THERE = Rule('not_there', lambda m: m.lost_node, 'roslaunch says: {lost_node}')
INPUTS = (
    Rule('input_type', lambda m: m.wrong_inputs,
         'You subscribe to {wrong_inputs}, which is not the type that the robot sends, '
         'so nothing arrives'),
    Rule('input', lambda m: m.status is None and not m.inputs_of_robot,
         'You listen to {inputs}; the robot sends, for example, /odom'))
LAST_WORDS = Rule('last_words', lambda m: m.said and m.status is not None, 'It said last: {said}')
ONE_COMMAND = Rule(
    'one_command', lambda m: len(m.moves) <= 5,
    'It stops 0.6 s after the last command, and you sent no more: repeat it in your loop')
RARE = Rule(
    'rare', lambda m: m.own_period > WATCHDOG,
    'Your commands come every {own_period:.1f} s, and the base stops 0.6 s after each')
BY_VERDICT = {
    'crash': (KEYBOARD, _error_if(_ended_with_error), NOT_THERE, LAST_WORDS),
    'no_node': (
        KEYBOARD, _error_if(_ended_with_error), NOT_THERE,
        Rule('main', lambda m: m.status == 0,
             'It never called rospy.init_node, and no ros::init was seen: is main() called?'),
        LAST_WORDS),
    'silent': (
        Rule('output_type', lambda m: m.output_type != m.type,
             'You publish {topic} as {output_type}, so nothing receives it: '
             'the exercise needs {type}'),
        Rule('queue_size', lambda m: m.run.refuses,
             'Your publisher takes connections and closes them: queue_size must be a number, '
             'as in queue_size=1, without quotation marks'),
        Rule('output', lambda m: m.outputs and m.topic not in m.run.publishes,
             'You publish {type} on {outputs}; the exercise names {topic}'),
        KEYBOARD, _error_if(_died_unnoticed), NOT_THERE,
        Rule('ended', lambda m: m.status == 0,
             'It ended by itself{after_words}. If it has callbacks, rospy.spin() or ros::spin() '
             'keeps it alive; what you publish before anybody is connected is lost'),
        *INPUTS),
    'all_zero': (KEYBOARD, _error_if(_only_input_fails), NOT_THERE, LAST_WORDS, *INPUTS),
    'before_start': (ONE_COMMAND,),
    'ceased': (
        _error_if(_fails_since_last_command), ONE_COMMAND,
        Rule('no_zero', lambda m: not m.is_short,
             'Publish a zero Twist when you are there, and before your node ends')),
    'late': (RARE,), 'unfinished': (RARE,),
    'interrupt': (
        Rule('hook', lambda m: m.error and m.hook_failed, 'Your shutdown hook failed: {error}'),
        Rule('again', lambda m: m.zero_after_ctrl_c,
             'You sent zero, and then drove again: let all loops, callbacks and threads that drive '
             'look at a flag, and set it before you send zero'),
        Rule('shutdown_roscpp', lambda m: m.run.is_cpp,
             'Publish a zero Twist before ros::shutdown(): '
             'take ros::init_options::NoSigintHandler and handle SIGINT'),
        Rule('on_shutdown', lambda m: True,
             'Publish a zero Twist in rospy.on_shutdown; after the loop it is too late')),
    'interrupt_ignored': (
        Rule('detached', lambda m: m.run.is_detached,
             'Your program has ended, and what it started runs on where Ctrl-C does not reach it'),
        Rule('ok', lambda m: m.run.is_cpp, 'Each loop, in each thread, needs while (ros::ok())'),
        Rule('handler', lambda m: m.run.answers,
             "rospy's shutdown has not come to its end: a hook of yours waits, or Ctrl-C was kept "
             'from rospy, by a signal handler of your own, disable_signals or a caught '
             'KeyboardInterrupt'),
        Rule('is_shutdown', lambda m: True,
             'Each loop, in each thread, needs while not rospy.is_shutdown()'))}
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
    Rule('radians', lambda m: m.follows == 'yaw' and abs(m.zero - RADIANS) < 0.5,
         'Your commands are zero at {zero:.1f} degrees, as if 90 degrees in radians were degrees: '
         'convert once, and compare like with like'),
    Rule('sign', lambda m: _has_wrong_sign(m) or m.plain and _has_wrong_sign(m.plain),
         'Your commands follow yaw - target, and turn away from it: '
         'ROS turns left for positive, so error = target - yaw'),
    Rule('quaternion', lambda m: m.follows == 'quaternion',
         'Your commands follow orientation.z, which is sin(yaw / 2) and no angle: '
         'use euler_from_quaternion'),
    Rule('half_circle', lambda m: m.follows == 'half_circle',
         'Your commands follow the error without its sign, as from asin() or abs(): '
         'use euler_from_quaternion, and keep the sign'),
    Rule('not_wrapped', lambda m: (m.rule == 'long_way' and m.follows in YAW and m.is_unwrapped
                                  and abs(m.zero - TARGET) < SAME_ANGLE),
         'Your commands follow target - yaw, which has to be wrapped, '
         'for example by atan2(sin(e), cos(e))'),
    Rule('gain_low', lambda m: m.rule == 'unfinished' and m.follows in YAW and 0 < m.gain < 0.2,
         'Your gain is {gain:.3f}, by which it takes minutes: try 0.5'),
    Rule('gain_high', lambda m: m.rule in ('rings', 'long_way') and m.follows in YAW and m.gain > 2,
         'Your gain is {gain:.1f}: lower it towards 0.5'),
    Rule('turns_by', lambda m: m.turns_by,
         'You turn by 90 degrees wherever you start; '
         'the exercise asks for heading 90 in the odom frame'))
FITS = (
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
         'Speed has a sign, distance has not: use abs(), or positions'),
    Rule('times', _fits('times'),
         'That is {factor:g} times the way, on each leg and at each rate'),
    Rule('last_step', lambda m: (m.rule == 'miscounted'
                                 and math.isclose(m.largest, m.largest_step, rel_tol=0.1)),
         'You published at most {largest:.3f} m, the size of one step: add each to the sum so far'))
COMPARED = (
    Rule('open_loop', lambda m: (_is_only_here(m) and m.scenario.name == 'slow_base'
                                 and abs(m.share - SLOW) < 0.03),
         'This base reaches 70 % of your speed, and so does your result: '
         'count odometry, not time or commands'),
    Rule('slow_odometry', lambda m: (m.fails_alone and m.rate < 20
                                     and m.rule in ('passed_by', 'rings', 'long_way')),
         'With odometry 20 times a second it is right; here one message is a step of '
         '{step:.2f} {unit}. Look for a window narrower than that, a high gain, '
         'or a fixed time for each message'),
    Rule('start', lambda m: _is_only_here(m) and m.scenario.name == 'moved_start',
         'In {plain.scenario.name} it is right: the result depends on where the robot starts'))
BY_EXERCISE = {'moved_distance': FITS, 'two_meters': PLACES, 'heading': ANGLES}
