"""The rules: what shows in a run that is not right, and the sentence for it. The first that holds counts."""

from typing import Callable, NamedTuple


class Rule(NamedTuple):
    """A mistake."""

    name: str
    holds: Callable  # of the namespace of odometry_check.measures.measure()
    sentence: str  # with measures in braces


def is_in(*names):
    """Return a function of measures: whether the scenario has one of these names."""
    return lambda m: m.name in names


START = (
    Rule('keyboard', lambda m: (m.error or '').startswith('EOFError'),
         'your node waits for the keyboard (line {line}), so a launch file cannot start it: read the value with '
         'rospy.get_param("~name", 90)'),
    Rule('syntax', lambda m: not m.run.nodes and (m.error or '').startswith(('SyntaxError', 'Indent', 'TabError')),
         'your node did not start: {error}, line {line}. Python 3 needs print(...), and plain ASCII operators'),
    Rule('unregistered', lambda m: not m.run.nodes and not m.ended,
         'your process registered no node within 20 s: something before rospy.init_node waits, perhaps for the '
         'keyboard'),
    Rule('crash', lambda m: m.ended and m.status != 0,
         'your node ended{at} with status {status}: {why}'),
    Rule('callback', lambda m: m.bad_callback,
         'your callback failed, and the node went on without it: {error}, line {line}'),
    Rule('type', lambda m: m.type and m.type != m.wanted,
         '{topic} has your type {type}, so nobody hears you: the exercise needs {wanted}'),
    Rule('elsewhere', lambda m: m.silent and m.elsewhere,
         'your commands go to {elsewhere}, where this robot does not listen: publish on cmd_vel'),
    Rule('unheard', lambda m: m.silent and m.unheard,
         'your node listens to {unheard}, which nobody publishes, and published nothing itself'),
    Rule('queue_size', lambda m: m.silent and m.refused,
         'your publisher of {topic} takes connections and closes them, and 0 messages came: queue_size must be a '
         'number; write queue_size=1, without quotation marks'),
    Rule('lost_command', lambda m: m.silent and m.ended,
         'your node ended by itself, and 0 messages came on {topic}: what you publish before anybody is '
         'connected is lost. Publish in a loop, or wait for get_num_connections()'),
    Rule('silent', lambda m: m.silent,
         'your node got {odometries} odometry messages and published 0 on {topic}: it waits for something else, or '
         'an except without a name hides the error: print it'))
DRIVE = (
    Rule('wrong_field', lambda m: m.useless and m.stays,
         'you set {useless}, and the robot did not move: a wheeled robot drives by linear.x and turns by angular.z'),
    Rule('never_began', lambda m: not m.moves,
         'you sent {sent} commands, and all of them were zero; the robot stands at ({x:g}, {y:g}), {start:.0f} '
         'degrees. Does your node compare with where it stands, and not with where it began?'),
    Rule('one_command', lambda m: m.ceased and m.run.interrupted is None and m.sent <= 5,
         'you sent {sent} command{s} and no more: this base stops 0.6 s after the last one, here at {gone:.2f} m and '
         '{turned:.0f} degrees. Repeat it in your loop'),
    Rule('interrupt_ignored', lambda m: m.run.interrupted is not None and not m.run.ends,
         'six seconds after Ctrl-C your node still ran: its loop never asks; write while not rospy.is_shutdown()'),
    Rule('interrupt', lambda m: m.run.interrupted is not None,
         'after Ctrl-C your last command was {last_word}, and only the base\'s watchdog stopped the robot: publish a '
         'zero Twist in rospy.on_shutdown'))
DISTANCE = (
    Rule('no_zero', lambda m: m.ceased and m.gone > 1.9 and m.gone < 2.2,
         'at {gone:.2f} m your commands ended with {last:.2f} m/s still set, and only the base\'s watchdog stopped '
         'the robot: publish a zero Twist at the goal'),
    Rule('ceased', lambda m: m.ceased,
         'your commands ended at {gone:.2f} of 2.00 m with {last:.2f} m/s still set: this base stops 0.6 s after the '
         'last one'),
    Rule('position', lambda m: m.name == 'moved_start' and m.gone < 0.3,
         'from ({x:g}, {y:g}) you drove {gone:.2f} of 2.00 m: you compare the position itself with 2, or count from '
         '(0, 0) since no odometry had come. Store the first position and take the difference'),
    Rule('one_axis', lambda m: m.name == 'moved_start' and m.stop and (
        abs(m.moved_x - 2) < 0.06 or abs(m.moved_y - 2) < 0.06),
         'heading {start:.0f} degrees you drove {gone:.2f} m where 2.00 were asked, and {moved_x:.2f} m along x, '
         '{moved_y:.2f} along y: only one axis counts. Take math.hypot(dx, dy)'),
    Rule('sum_of_axes', lambda m: m.name == 'moved_start' and m.stop and abs(m.axes - 2) < 0.06,
         'heading {start:.0f} degrees you drove {gone:.2f} of 2.00 m: {moved_x:.2f} along x and {moved_y:.2f} along '
         'y make {axes:.2f}. The way is not their sum: take math.hypot(dx, dy)'),
    Rule('elapsed_time', lambda m: m.stop and m.early and abs(m.commanded - 2) < 0.12,
         'you stopped at {gone:.2f} of 2.00 m, after {driven:.1f} s: {commanded:.2f} m by your own commands, but the '
         'base is slower than them. Count odometry, not time'),
    Rule('early', lambda m: m.stop and m.early,
         'you stopped at {at_stop:.2f} m and rest at {gone:.2f} of 2.00 m. Is that a tolerance or a rounding, or '
         'meant for braking? At 0.1 m/s that needs 0.002 m'),
    Rule('too_slow', lambda m: m.gone < 1.95 and not m.stop,
         'after {driven:.0f} s you are at {gone:.2f} of 2.00 m, with {last:.3f} m/s'),
    Rule('window', lambda m: not m.stop and m.name == 'odom_5hz',
         'with odometry at 5 Hz you passed 2.00 m and were at {gone:.2f} m when this was ended: each message is a '
         'step of {step:.2f} m, and jumps over your window. Stop at distance >= 2, not near 2'),
    Rule('goal_point', lambda m: not m.stop and m.name == 'moved_start',
         'from ({x:g}, {y:g}), heading {start:.0f} degrees, you passed 2.00 m and were at {gone:.2f} m when this was '
         'ended: one axis alone counts, or you missed a goal point beside your way. Count the way from the start'),
    Rule('passed_by', lambda m: not m.stop,
         'you passed 2.00 m and were at {gone:.2f} m when this was ended, still with {last:.2f} m/s: a distance is '
         'hardly ever equal (use >=), or your loop looks at a value that it copied once. Print it'),
    Rule('late', lambda m: m.delay > m.bound,
         'your zero came {delay:.1f} s after the odometry that crossed 2.00 m, and the robot rests at {gone:.2f} m: '
         'two periods are {bound:.1f} s. Does your loop look at each message?'),
    Rule('other', lambda m: True, 'the robot ended at {gone:.2f} m where 2.00 were asked'))
HEADING = (
    Rule('ceased', lambda m: m.ceased,
         'your commands ended at {yaw:.1f} degrees with {last:.2f} rad/s still set, and only the base\'s watchdog '
         'stopped the robot: publish a zero Twist at the goal'),
    Rule('window', lambda m: m.name == 'odom_5hz' and m.turned > m.shortest + 180 and m.is_constant and m.flips < 5,
         'with odometry at 5 Hz you turned {turned:.0f} degrees for {shortest:.0f}: steps of {turn_step:.1f} degrees '
         'jump over your window. Slow down near the goal: kp * error'),
    Rule('degrees', lambda m: abs(m.net) > 540 and m.typical > 3.1,
         'you commanded {typical:.2f} rad/s and turned {turned:.0f} degrees for {shortest:.0f}: yaw is in radians, and '
         'your target looks like degrees. Use math.radians'),
    Rule('equality', lambda m: abs(m.net) > 540 and m.is_constant,
         'you turned {turned:.0f} degrees for {shortest:.0f} at {typical:.2f} rad/s: your test for the goal never '
         'holds. Is it for equality, or does your loop read a value that it copied once?'),
    Rule('quaternion', lambda m: abs(m.net) > 540,
         'you turned {turned:.0f} degrees for {shortest:.0f}, with {least:.2f} to {top_turn:.2f} rad/s: your error never '
         'reached zero. orientation.z is sin(yaw/2), no angle (use euler_from_quaternion), or the error is not wrapped'),
    Rule('sign', lambda m: m.first * m.error_at_start < 0 and not (m.settled and m.near),
         'for {error_at_start:+.0f} degrees your first command was {first:.2f} rad/s, away from the goal. ROS turns '
         'left for positive: error = target - yaw'),
    Rule('chatter', lambda m: m.rings and m.is_constant and m.near,
         'at the goal your command flipped {flips} times between {typical:.2f} and -{typical:.2f} rad/s, where a zero '
         'should end it. Make it proportional: kp * error'),
    Rule('gain_high', lambda m: m.rings or m.turned - abs(m.net) > 60,
         'you turned {turned:.0f} degrees for {shortest:.0f}, your command changed its sign {flips} times and was as '
         'large as {top_turn:.2f} rad/s: the gain is too high, or an angle in degrees is taken for radians. Lower kp '
         'towards 0.5'),
    Rule('wrap', lambda m: m.long_way and m.near,
         'you turned {turned:.1f} degrees where {shortest:.1f} the other way were enough: the error target - yaw has to be '
         'wrapped, for example atan2(sin(e), cos(e)); or your yaw is of half a circle only, as from asin'),
    Rule('jump', lambda m: m.name == 'moved_start' and m.settled and abs(abs(m.yaw) - 180) < 6,
         'from {start:.0f} degrees you stopped at {yaw:.1f} after {turned:.0f}: there yaw jumps from -180 to 180, and a '
         'difference becomes 350. Wrap it'),
    Rule('turns_by', lambda m: m.name == 'moved_start' and m.settled and not m.near and abs(m.net - 90) < 8,
         'from {start:.0f} degrees you ended at {yaw:.1f}: you turned by {net:.0f}, or for a time. The exercise asks '
         'for heading 90 in the odom frame'),
    Rule('gain_low', lambda m: not m.settled or m.moves_at_end,
         'after {driven:.0f} s you were {off:.0f} degrees off, with {last:.3f} rad/s: with so low a gain it takes '
         'minutes. Try kp = 0.5'),
    Rule('short', lambda m: m.off < 25,
         'you rest at {yaw:.1f} degrees, {off:.1f} from 90: a tolerance of that size, or one on sines or matrix '
         'elements. Compare angles'),
    Rule('other_goal', lambda m: True,
         'you rest at {yaw:.1f} degrees where 90 were asked, after turning {turned:.1f}: is the goal computed in '
         'radians, and the yaw by euler_from_quaternion?'))
DETECTOR = (
    Rule('displacement', lambda m: m.fits == 'displacement',
         'out and back is {out_and_back:.2f} m, and you published {counted_back:.2f}: that is the distance from the '
         'start, a possible reading of "moved". For the way driven add up the steps'),
    Rule('from_origin', lambda m: m.fits in ('origin', 'first_step'),
         'before the robot moved you published {offset:.2f} m: your first step counts from (0, 0). Take the first '
         'message as the start'),
    Rule('one_axis', lambda m: m.fits in ('x_only', 'y_only', 'signed_x'),
         '{leg} you counted {leg_counted:.2f} of {leg_right:.2f} m: one axis only. Does your y difference use both '
         'messages?'),
    Rule('sum_of_axes', lambda m: m.fits in ('axes', 'signed_axes'),
         '{leg} you counted {leg_counted:.2f} of {leg_right:.2f} m: dx + dy is no distance, math.hypot(dx, dy) is'),
    Rule('rounded', lambda m: (m.fits or '').startswith('rounded'),
         '{leg} you counted {leg_counted:.2f} of {leg_right:.2f} m, in steps of rounded positions. Round when you '
         'print, not before you add'),
    Rule('signed_speed', lambda m: m.fits == 'signed_speed',
         'driving back {right_back:.2f} m you published {back:.2f}: speed has a sign, distance has not. Use abs(), or '
         'positions'),
    Rule('fixed_dt', lambda m: m.fits in ('times_signed_speed', 'times_speed'),
         'you counted {total:.2f} of {right:.2f} m, which is speed times {dt:.3f} s for each message, where '
         '{true_dt:.3f} s are between two. Take the time from the stamps, or positions; and backwards use abs()'),
    Rule('times', lambda m: m.fits == 'times_total',
         'you counted {total:.2f} of {right:.2f} m, {factor:.2f} times as much on each leg: is each step added more '
         'than once, or in another unit?'),
    Rule('last_step', lambda m: m.largest < 0.3,
         'you published at most {largest:.3f} m, the size of one step: add each to the sum so far'),
    Rule('squares', lambda m: m.fits == 'squares', 'you counted {total:.2f} of {right:.2f} m, the squares of the '
         'steps: take the square root'),
    Rule('other', lambda m: True,
         '{leg} you counted {leg_counted:.2f} of {leg_right:.2f} m, and {total:.2f} of {right:.2f} in all: do you miss '
         'messages, or count some twice?'))
NOTES = (
    Rule('no_sleep', lambda m: m.run.unawaited and m.sent / m.duration > 200,
         'your loop sent {sent} commands in {duration:.0f} s, where {few:.0f} do: add rospy.Rate(10) and '
         'rate.sleep(). It is judged at {pace:g} times real time'),
    Rule('wall_time', lambda m: m.run.unawaited and not m.sent / m.duration > 200,
         'your node {unawaited}. It is judged at {pace:g} times real time'),
    )
DRIVE_NOTES = (
    Rule('mux', lambda m: m.mux, 'your commands go to {mux}; the exercise names cmd_vel. This robot obeys both'),
    Rule('too_fast', lambda m: m.top_speed > 0.71, 'you commanded {top_speed:.1f} m/s; this base does 0.7'),
    Rule('stops_early', lambda m: m.short_by > 0.01 and m.passed,
         'you rest at {gone:.3f} m: is that a tolerance? Compare without rounding'),
    Rule('hidden_error', lambda m: m.bad_callback and m.passed, 'a callback failed: {error}, line {line}'),
    Rule('ctrl_c', lambda m: not m.run.ends and m.run.interrupted is None,
         'Ctrl-C did not end your node: write while not rospy.is_shutdown()'))
