"""Rules that judge a run by what was measured; the first that holds is the verdict.

Causes are in hints.py.
"""

from sim_turtlebot.kobuki import CMD_VEL_TIMEOUT, MAX_LINEAR_SPEED

from odometry_tools.check.drive_measures import AT_TARGET, DETOUR
from odometry_tools.check.rule import Rule


def _exits_when_done(m):
    """Return whether a node stopped, or was there, and then exited with a status of its choice."""
    return m.status > 0 and not m.error and (m.stop or not m.is_short)


def _turns_too_far(m):
    """Return whether it turns too far; one that rests elsewhere has another mistake."""
    return m.turned > m.shortest + DETOUR and not (m.is_short and m.is_settled and m.stop)


START = (
    Rule('crash', lambda m: m.status and m.run.interrupted is None and not _exits_when_done(m),
         'your node ended {how}{at}'),
    Rule('no_node', lambda m: not m.run.nodes and m.status is None,
         'your process has registered no node'),
    Rule('no_node', lambda m: not (m.run.nodes or m.run.has_begun),
         'your process ended {how} without having become a node'),
    Rule('wall_clock', lambda m: m.run.follows_wall,
         "two runs of this scenario differ: your node follows the wall's clock, "
         'as time.time() does, or chance. '
         'rospy.get_time() follows the robot', explains=True),
    Rule('silent', lambda m: m.is_silent,
         'nothing from your node arrived on {topic}'),
    Rule('not_finite', lambda m: not m.is_finite,
         'you published what is not a number (nan or inf) on {topic}'))
DRIVE = (
    Rule('wrong_field', lambda m: m.useless and m.is_still,
         'you set {useless}, and the robot did not move: '
         'a wheeled robot drives by linear.x and turns by angular.z',
         explains=True),
    Rule('all_zero', lambda m: not m.moves,
         'from ({start.x:.1f}, {start.y:.1f}), heading {start_heading:.0f} degrees, '
         'all commands that arrived were zero'),
    Rule('before_start', lambda m: (m.moves and not (m.has_moved or m.stop)
                                    and m.moves[-1].time <= 0.0),
         'your last command, {last_word}, came before simulated time began, '
         'and the robot did not move'),
    Rule('interrupt_ignored', lambda m: m.run.interrupted is not None and not m.run.ends,
         '30 simulated seconds after Ctrl-C your node still ran'),
    Rule('interrupt_again', lambda m: m.drove_again,
         'after Ctrl-C you sent zero, and then drove again: let all loops, callbacks and threads '
         'that drive look at a flag, and set it before you send zero', explains=True),
    Rule('interrupt_late', lambda m: m.run.interrupted is not None and not m.commands[-1].moves,
         'you drove on for {driven_on:.1f} s after Ctrl-C, and only then sent zero', explains=True),
    Rule('interrupt', lambda m: m.run.interrupted is not None,
         "after Ctrl-C your last command was {last_word}, "
         "and only the base's watchdog stopped the robot"))
DISTANCE = (
    Rule('only_turned', lambda m: m.turns and not m.drives,
         'you only turned the robot; this exercise drives it', explains=True),
    Rule('ceased', lambda m: m.has_ceased,
         'your last command, {last_word}, came at {at_last.way:.2f} m, '
         "and only the base's watchdog stopped the robot, "
         'at {end.way:.2f} m'),
    Rule('early', lambda m: m.stop and m.is_short,
         'you stopped at {at_stop.way:.2f} m, and rest at {end.way:.2f} of 2.00 m'),
    Rule('unfinished', lambda m: m.is_short,
         'after {seconds:.0f} s you are at {end.way:.2f} of 2.00 m, '
         'and your last command was {last_word}'),
    Rule('drove_on', lambda m: m.pause,
         'you sent zero at {pause.way:.2f} m, and then drove on; '
         'the robot {stays} at {reached}'),
    Rule('passed_by', lambda m: not m.stop,
         'you passed 2.00 m and were at {end.way:.2f} m when this was ended, '
         'still with {last_word}'),
    Rule('late', lambda m: True,
         'your zero came {delay:.1f} s after the odometry that crossed 2.00 m, '
         'where {bound:.1f} s are allowed; the robot {stays} at {reached}'))
HEADING = (
    Rule('only_drove', lambda m: m.drives and not m.turns,
         'you only drove the robot; this exercise turns it', explains=True),
    Rule('ceased', lambda m: m.has_ceased,
         'your last command, {last_word}, came after {turned_at_last:.0f} degrees, and only the '
         "base's watchdog stopped the robot, at heading {heading:.1f}"),
    Rule('rings', lambda m: m.rings,
         'your command changed its sign {flips} times until this was ended, '
         'and the robot did not come to rest at 90 degrees'),
    Rule('long_way', lambda m: (_turns_too_far(m) and m.goes_shorter_way
                               and m.swing > AT_TARGET),
         'you swung {swing:.0f} degrees past 90, and turned {turned:.0f} in all, '
         'where {shortest:.0f} are enough'),
    Rule('long_way', lambda m: _turns_too_far(m) and m.run.is_driving,
         'you had turned {turned:.0f} degrees when this was ended, still with {last_word}, '
         'where {shortest:.0f} are enough'),
    Rule('long_way', _turns_too_far,
         'you turned {turned:.0f} degrees where {shortest:.0f} are enough'),
    Rule('drives_on', lambda m: m.drives_on and not m.is_short,
         'the robot still drove at {end.linear:.2g} m/s when this was ended, at heading '
         '{heading:.1f}: send zero for linear.x, too', explains=True),
    Rule('unfinished', lambda m: not (m.is_settled and m.stop),
         'after {seconds:.0f} s you are {heading_error:.0f} degrees off, '
         'and your last command was {last_word}'),
    Rule('elsewhere', lambda m: True,
         'you rest at {heading:.1f} degrees where 90 were asked, after turning {turned:.0f}'))
DETECTOR = (
    Rule('displacement', lambda m: ('displacement', 1.0) in m.fits,
         'out and back is {out_and_back:.2f} m, and you published {counted_back:.2f}: '
         'that is the distance from the start, a possible reading of "moved". '
         'For the way driven add up the steps', explains=True),
    Rule('falls', lambda m: m.only_falls,
         'you published {fell_from:.2f} m and then {fell_to:.2f}: a distance moved never falls',
         explains=True),
    Rule('miscounted', lambda m: True,
         '{leg} you counted {leg_counted:.2f} of {leg_right:.2f} m, '
         'and {total:.2f} of {right:.2f} in all'))
PRAISE = {
    'moved_distance': 'counted {total:.2f} of {right:.2f} m',
    'two_meters': 'at {reached} after {driven:.1f} s',
    'heading': 'at {heading:.2f} degrees after {arrival:.1f} s',
    'interrupt': 'stopped the robot after Ctrl-C',
    'paced': 'as far as can be said of a node that simulated time cannot wait for'}
# Notes are independent of the verdict.
NOTES = (
    Rule('no_sleep', lambda m: m.is_busy,
         'your node computes without a pause: in a loop, add rospy.Rate(10) and rate.sleep(). '
         'Simulated time cannot wait for it, so it was judged with wider bounds'),
    Rule('wall_time', lambda m: m.run.unawaited and not (m.is_busy or m.is_silent),
         'your node {run.unawaited}. '
         'Simulated time cannot wait for it, so it was judged with wider bounds'),
    Rule('error', lambda m: (m.error and m.run.interrupted is None
                             and m.hint not in ('error', 'callback', 'printed')),
         'your node printed an error: {error}'),
    Rule('exit_status', lambda m: (m.status and m.run.interrupted is None
                                   and m.rule not in ('no_node', 'crash')),
         'your node ended {how}{after_words}'),
    Rule('ctrl_c', lambda m: not m.run.ends and m.run.interrupted is None,
         'Ctrl-C did not end your node within 30 simulated seconds'),
    Rule('leaves_process', lambda m: m.run.leaves_process,
         'after Ctrl-C a program that your node had started still ran'),
    Rule('luck', lambda m: m.passed and m.run.has_lost_message and not m.run.unawaited,
         'it passed only when it was run again. '
         'What a program publishes as it ends can be lost: '
         'rospy.sleep(0.5) after it gives it time to arrive'),
    Rule('commands', lambda m: m.exercise.route and m.commands,
         'your detector commands the robot, too, which the check drives'),
    Rule('ground_truth', lambda m: '/base_pose_ground_truth' in m.run.subscribes,
         'your node listens to /base_pose_ground_truth, which no real robot has: use /odom'),
    Rule('keyboard', lambda m: m.run.has_read_keyboard and m.hint != 'keyboard',
         'your node reads the keyboard, which a launch file cannot offer'),
    Rule('fast', lambda m: m.fastest > MAX_LINEAR_SPEED,
         'you commanded {fastest:.2g} m/s; this base reaches 0.7'),
    Rule('rare', lambda m: m.own_period > CMD_VEL_TIMEOUT,
         'your commands come every {own_period:.1f} s, and the base stops 0.6 s after each'),
    Rule('mux', lambda m: m.mux,
         'your commands go to {mux}; the exercise names cmd_vel. This robot obeys both'))
