"""Hints: what else the check saw of a failure, and its cause only where it saw proof of it.

Each rule looks at the graph, the output, an exit status or a fit. Those that always hold are advice
on what the verdict itself has shown.
"""

from sim_turtlebot.kobuki import CMD_VEL_TIMEOUT

from odometry_tools.check.motion_hints import ANGLES, COMPARED, PLACES, SUMS
from odometry_tools.check.rule import Rule, first

UNKNOWN = (
    Rule('printed', lambda m: m.error,
         'We do not know why, but your node printed an error: {error}'),
    Rule('', lambda m: m.is_silent,
         'We do not know why: print a line before you publish, to see whether it is reached; '
         'what you publish before anybody is connected is lost'),
    Rule('', lambda m: m.plain is None and m.run.odometry,
         'We do not know why: print the {quantity} in your loop, look at the picture, '
         'or leave out --scenario: the others may show it'),
    Rule('', lambda m: True,
         'We do not know why: print the {quantity} in your loop, and look at the picture'))
BURST = 0.11  # s; some nodes repeat a command at once, lest one be lost
NO_INPUT = 'EOFError', 'ValueError', 'IndexError'  # errors after an empty line from the keyboard
MANY = 500  # failures of a callback; the output that is kept may hold no more


def hint_for(m):
    """Return the Rule that names the cause of a failure, or one that says it is unknown."""
    return first((*BY_VERDICT.get(m.rule, ()), *BY_EXERCISE[m.exercise.name], *COMPARED,
                  CALLBACK, *UNKNOWN), m)


def _fails_at_keyboard(m):
    """Return whether it has read the keyboard, and no error speaks of something else."""
    return m.run.has_read_keyboard and (not m.error or m.error.startswith(NO_INPUT))


def _comes_at_once(m):
    """Return whether all of its commands came at one moment."""
    return m.moves[-1].time - m.moves[0].time < BURST and m.silence > CMD_VEL_TIMEOUT


KEYBOARD = Rule(
    'keyboard', _fails_at_keyboard,
    'Your node reads the keyboard, which a launch file cannot offer: make the value a parameter')
# Python exits with 1 after an error of the main thread; a hook may print something then.
ERROR = Rule(
    'error', lambda m: (m.ends_with_error
                        or m.status == 1 and m.main_error and m.error == m.main_error),
    '{error}')
# It says what was seen: the callback may be of another topic than the one that matters.
CALLBACK = Rule(
    'callback', lambda m: m.error and m.failures > min(m.rate * m.run.now / 2, MANY),
    'Your callback fails again and again: {error}')
NOT_THERE = Rule('not_there', lambda m: m.lost_node, 'roslaunch says: {lost_node}')
INPUTS = (
    Rule('input_type', lambda m: m.wrong_inputs,
         'You subscribe to {wrong_inputs}, so nothing arrives'),
    Rule('input', lambda m: m.status is None and m.inputs and not m.inputs_of_robot,
         'You listen to {inputs}; there is, for example, {likely_input}'),
    Rule('no_input', lambda m: m.status is None and m.exercise.route and not m.inputs,
         'You have subscribed to no topic so far: an earlier line may be waiting'))
OUTPUT = Rule('output', lambda m: m.outputs,
              'You publish {outputs}; the exercise needs {topic} as {type}')
ENDED = Rule('ended', lambda m: m.status == 0, 'Your node ended by itself{after_words}')
LAST_WORDS = Rule('last_words', lambda m: m.said and m.status is not None, 'It said last: {said}')
ONE_COMMAND = Rule(
    'one_command', _comes_at_once,
    'The base stops 0.6 s after a command: repeat it in your loop')
BY_VERDICT = {
    'crash': (KEYBOARD, ERROR, NOT_THERE, LAST_WORDS),
    'no_node': (
        KEYBOARD, ERROR, NOT_THERE,
        Rule('main', lambda m: m.status == 0,
             'It never called rospy.init_node, and no ros::init was seen: is main() called?'),
        LAST_WORDS),
    'silent': (
        Rule('queue_size', lambda m: m.run.refuses,
             'Your publisher takes connections and closes them: queue_size must be a number, '
             'as in queue_size=1, without quotation marks'),
        OUTPUT._replace(test=lambda m: m.is_near_miss),
        KEYBOARD, NOT_THERE,
        Rule('ended', lambda m: m.status == 0,
             'It ended by itself{after_words}. If it has callbacks, rospy.spin() or ros::spin() '
             'keeps it alive; what you publish before anybody is connected is lost'),
        *INPUTS,
        OUTPUT,
        Rule('no_output', lambda m: m.status is None and m.run.publishes.keys() <= {'/rosout'},
             'Your node has advertised no topic so far: an earlier line may be waiting')),
    'all_zero': (KEYBOARD, NOT_THERE, ENDED, *INPUTS),
    'before_start': (ONE_COMMAND,),
    'ceased': (
        ONE_COMMAND,
        Rule('no_zero', lambda m: m.was_there,
             'Publish a zero Twist when you are there, and before your node ends')),
    'early': (ONE_COMMAND,),
    'unfinished': INPUTS,
    'passed_by': INPUTS,
    'miscounted': (ENDED,),
    'interrupt': (
        Rule('hook', lambda m: m.hook_error, 'Your shutdown hook failed: {hook_error}'),
        Rule('shutdown_roscpp', lambda m: m.run.is_cpp,
             'Publish a zero Twist before ros::shutdown(): '
             'take ros::init_options::NoSigintHandler and handle SIGINT'),
        Rule('on_shutdown', lambda m: True,
             'Publish a zero Twist in rospy.on_shutdown; after the loop it is too late')),
    'interrupt_ignored': (
        Rule('ok', lambda m: m.run.is_cpp, 'Each loop, in each thread, needs while (ros::ok())'),
        Rule('is_shutdown', lambda m: True,
             'Each loop, in each thread, needs while not rospy.is_shutdown() and a pause, and each '
             'wait a timeout. Ctrl-C must reach rospy, and all that your node starts'))}
BY_EXERCISE = {'moved_distance': SUMS, 'two_meters': PLACES, 'heading': ANGLES}
