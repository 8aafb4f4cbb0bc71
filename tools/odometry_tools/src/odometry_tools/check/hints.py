"""Hints: what else the check saw of a failure, and its cause only where it saw proof of it.

Each rule looks at the graph, the output, an exit status or a fit. Those that always hold are advice
on what the verdict itself has shown.
"""

from odometry_tools.check.motion_hints import ANGLES, COMPARED, PLACES, SUMS
from odometry_tools.check.rule import Rule, first

UNKNOWN = (
    Rule('', lambda m: m.is_silent,
         'We do not know why: print a line before you publish, to see whether it is reached'),
    Rule('', lambda m: m.plain is None and m.run.odometry,
         'We do not know why: print the {quantity} in your loop, look at the picture, '
         'or leave out --scenario: the others may show it'),
    Rule('', lambda m: True,
         'We do not know why: print the {quantity} in your loop, and look at the picture'))
WATCHDOG = 0.6  # s
BURST = 0.11  # s; some nodes repeat a command at once, lest one be lost
NO_INPUT = 'EOFError', 'ValueError', 'IndexError'  # errors after an empty line from the keyboard
# As termios prints it, by which single keys are read; other uses of a terminal print [Errno 25].
NO_TERMINAL = "(25, 'Inappropriate ioctl for device')"
RARE_FAILS = 'late', 'unfinished', 'rings', 'long_way'
MANY = 500  # failures of a callback; the output that is kept may hold no more


def hint_for(m):
    """Return the Rule that names the cause of a failure, or one that says it is unknown."""
    known = *BY_VERDICT.get(m.rule, ()), *BY_EXERCISE[m.exercise.name], *COMPARED
    return first((*known, *UNKNOWN), m)


def _error_if(test, words=''):
    """Return a hint that quotes the last error, after some words, if `test` of measures holds."""
    return Rule('error', lambda m: m.error and test(m), f'{words}{{error}}')


def _ended_with_error(m):
    # Python exits with 1 after an error; after an earlier one it may have another reason.
    return m.ends_with_error or m.status == 1 and m.has_late_error and not m.failures


def _only_input_fails(m):
    """Return whether the callback that is the node's only input failed for most messages."""
    half_of_messages = m.rate * m.run.now / 2
    return len(m.inputs_of_robot) == 1 and m.failures > min(half_of_messages, MANY)


def _never_works(m):
    """Return whether the only callback fails, all commands are the same, and nothing passes."""
    speeds = {(command.linear, command.angular) for command in m.moves}
    return len(speeds) == 1 and _only_input_fails(m) and not (m.plain and m.plain.passed)


def _fails_since_last_command(m):
    messages = m.rate * (m.run.now - m.commands[-1].time)
    return m.failures == m.late_failures > messages / 2


def _fails_at_keyboard(m):
    """Return whether it has read the keyboard, and no error speaks of something else."""
    return (NO_TERMINAL in m.error
            or m.run.has_read_keyboard and (not m.error or m.error.startswith(NO_INPUT)))


def _comes_at_once(m):
    """Return whether it sends a command once, or a few of them too rarely."""
    is_burst = m.moves[-1].time - m.moves[0].time < BURST
    return ((is_burst or len(m.moves) <= 5 and m.own_period > WATCHDOG)
            and m.silence > max(WATCHDOG, 2 * m.own_period))


KEYBOARD = Rule(
    'keyboard', _fails_at_keyboard,
    'Your node reads the keyboard, which a launch file cannot offer: make the value a parameter')
NOT_THERE = Rule('not_there', lambda m: m.lost_node, 'roslaunch says: {lost_node}')
INPUTS = (
    Rule('input_type', lambda m: m.wrong_inputs,
         'You subscribe to {wrong_inputs}, so nothing arrives'),
    Rule('input', lambda m: m.status is None and m.inputs and not m.inputs_of_robot,
         'You listen to {inputs}; there is, for example, {likely_input}'),
    Rule('no_input', lambda m: m.status is None and m.exercise.route and not m.inputs,
         'You have subscribed to no topic so far: an earlier line may be waiting'))
# These say what was seen: the topics do not show whether it was the cause.
CALLBACK, THREAD = 'Your callback fails again and again: ', 'A thread of yours ended: '
BLIND = _error_if(_never_works, CALLBACK)
LAST_WORDS = Rule('last_words', lambda m: m.said and m.status is not None, 'It said last: {said}')
ONE_COMMAND = Rule(
    'one_command', _comes_at_once,
    'The base stops 0.6 s after a command: repeat it in your loop')
RARE = Rule(
    'rare', lambda m: (m.rule in RARE_FAILS and m.own_period > WATCHDOG
                       and not m.pauses and not (m.plain and m.plain.passed)),
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
        KEYBOARD, _error_if(_only_input_fails, CALLBACK),
        _error_if(lambda m: m.has_dead_thread, THREAD),
        _error_if(lambda m: m.status == 0 and m.ends_with_error), NOT_THERE,
        Rule('ended', lambda m: m.status == 0 and (m.plain is None or m.plain.is_silent),
             'It ended by itself{after_words}. If it has callbacks, rospy.spin() or ros::spin() '
             'keeps it alive; what you publish before anybody is connected is lost'),
        Rule('ended_here', lambda m: m.status == 0,
             'Here it ended by itself{after_words}; in {plain.scenario.name} it published'),
        *INPUTS,
        Rule('service', lambda m: m.status is None and m.services,
             'Your node offers the service {services}, which nobody calls here: '
             'if it waits for a call, let it begin by itself'),
        Rule('no_output', lambda m: m.status is None and m.run.publishes.keys() <= {'/rosout'},
             'Your node has advertised no topic so far: an earlier line may be waiting')),
    'all_zero': (
        KEYBOARD, _error_if(_only_input_fails, CALLBACK), NOT_THERE, LAST_WORDS, *INPUTS,
        Rule('ended_itself', lambda m: m.status == 0,
             'Your node ended by itself: look at what ends it, such as the condition of a loop')),
    'before_start': (ONE_COMMAND,),
    'ceased': (
        _error_if(_fails_since_last_command, CALLBACK), ONE_COMMAND,
        Rule('no_zero', lambda m: m.was_there,
             'Publish a zero Twist when you are there, and before your node ends'),
        _error_if(lambda m: m.has_late_dead_thread, THREAD)),
    'early': (ONE_COMMAND,),
    'unfinished': (BLIND, *INPUTS),
    'passed_by': (BLIND, *INPUTS),
    'long_way': (BLIND,),
    'interrupt': (
        Rule('hook', lambda m: m.hook_error, 'Your shutdown hook failed: {hook_error}'),
        Rule('shutdown_roscpp', lambda m: m.run.is_cpp,
             'Publish a zero Twist before ros::shutdown(): '
             'take ros::init_options::NoSigintHandler and handle SIGINT'),
        Rule('on_shutdown', lambda m: True,
             'Publish a zero Twist in rospy.on_shutdown; after the loop it is too late')),
    'interrupt_ignored': (
        Rule('detached', lambda m: m.run.is_detached,
             'Your program has ended, and what it started runs on where Ctrl-C does not reach it'),
        Rule('ok', lambda m: m.run.is_cpp, 'Each loop, in each thread, needs while (ros::ok())'),
        # In one that computes without a pause, Ctrl-C often waits for a lock that a loop holds.
        Rule('handler', lambda m: m.run.answers and not m.is_busy,
             "rospy's shutdown has not come to its end: a hook of yours waits, or Ctrl-C was kept "
             'from rospy, by a signal handler of your own, disable_signals or a caught '
             'KeyboardInterrupt'),
        Rule('is_shutdown', lambda m: True,
             'Each loop, in each thread, needs while not rospy.is_shutdown(), '
             'and each wait a timeout'))}
BY_EXERCISE = {'moved_distance': SUMS, 'two_meters': (*PLACES, RARE), 'heading': (*ANGLES, RARE)}
