"""Measures of a Run: the names that rules, hints and their sentences use."""

import math
from types import SimpleNamespace

from odometry_tools.check.detector import measure_detector
from odometry_tools.check.drive_measures import measure_distance, measure_drive, measure_heading
from odometry_tools.runs import quoting
from odometry_tools.runs.plain_text import plain
from odometry_tools.runs.recorded_run import COMMAND_TOPICS

BUSY = 'has been busy'  # in lockstep's message: the node exceeded its CPU budget
# Messages of rospy and of roslaunch.
BAD_CALLBACK, LOST_NODE = 'bad callback', 'cannot launch node of type'
HOOK_FAILED, IN_MAIN = ', in signal_shutdown\n', ', in <module>\n'  # in a traceback
DRIVEN_ON = 5.0  # s of driving after Ctrl-C that pass
OLD_TF = 'tf/tfMessage'  # has the checksum of the new one
# Topics from which a node may learn about the robot, and their types.
INPUTS = {
    '/odom': 'nav_msgs/Odometry',
    '/base_pose_ground_truth': 'nav_msgs/Odometry',
    '/moved_distance': 'std_msgs/Float64',
    '/tf': 'tf2_msgs/TFMessage',
    '/joint_states': 'sensor_msgs/JointState',
    '/mobile_base/sensors/imu_data': 'sensor_msgs/Imu'}


def measure(run, exercise):
    """Return the measures of a Run of an Exercise, as a namespace."""
    m = SimpleNamespace(
        run=run, scenario=run.scenario, exercise=exercise, topic=exercise.topic, type=exercise.type,
        target=exercise.target, commands=run.commands, rate=run.scenario.odom_rate,
        quantity='distance' if exercise.target is None else 'heading',
        unit='m' if exercise.target is None else 'degrees')
    # What a run without odometry, or without commands, does not show.
    m.passed = False
    m.is_short = True
    m.was_there = False
    m.at = m.mux = m.follows = ''
    m.is_busy = BUSY in (run.unawaited or '')
    m.share = m.own_period = m.fastest = 0.0
    m.fits = m.net = m.stop = None
    _measure_messages(m)
    _read_output(m, plain(run.output))
    _read_graph(m, run.publishes, run.subscribes)
    if exercise.route and m.is_finite:
        measure_detector(m, run)
    elif run.odometry and m.is_finite:
        measure_drive(m, run)
        if exercise.target is None:
            measure_distance(m, run)
        else:
            measure_heading(m, run)
        if run.interrupted is not None:
            has_stopped = not run.commands[-1].moves and m.driven_on < DRIVEN_ON
            m.passed = run.ends and has_stopped
    return m


def _read_output(m, output):
    """Measure what the node printed, and how it ended."""
    m.error = quoting.error_in(output)
    m.said = quoting.last_line(output)
    m.main_error = quoting.error_in(output, IN_MAIN)
    m.ends_with_error = quoting.ends_with_error(output)
    last = m.error if m.ends_with_error else m.said
    m.after_words = f', and said last: {last}' if last else ''
    m.failures = output.count(BAD_CALLBACK)
    m.hook_error = quoting.error_in(output, HOOK_FAILED)
    m.lost_node = next((line for line in output.split('\n') if LOST_NODE in line), '')
    m.status = _status_in(m, output)
    m.how = '' if m.status is None else quoting.how_ended(m.status)


def _status_in(m, output):
    """Return the exit status of the node, or of a launch file's node that has ended.

    One that has never registered counts if no other can be the one that is judged.
    """
    may_be_node = m.is_silent and (m.error or m.topic not in m.run.publishes)
    for name, status in quoting.DIED.findall(output):
        is_node = not name or f'/{name}' in m.run.nodes
        if is_node or may_be_node:
            return int(status)
    return m.run.status


def _measure_messages(m):
    """Measure what the node published."""
    published = [speed for command in m.commands for speed in (command.linear, command.angular)]
    if m.exercise.route:
        published = [value for _, value in m.run.moved] if m.run.legs else []
    m.is_silent = not (published and m.run.odometry)
    m.is_finite = all(map(math.isfinite, published))


def _read_graph(m, publishes, subscribes):
    """Measure which topics the node publishes and subscribes to, from types by topic."""
    has_output = any(kind in ('', m.type) and topic in (m.topic, *COMMAND_TOPICS)
                     for topic, kind in publishes.items())
    others = {} if has_output else {
        topic: kind for topic, kind in publishes.items() if kind and topic != '/rosout'}
    m.outputs = quoting.listed(f'{topic} as {kind}' for topic, kind in others.items())
    m.is_near_miss = m.topic in others or m.type in others.values()
    heard = subscribes.keys() - {'/clock', '/rosout'}
    m.inputs = quoting.listed(heard)
    m.inputs_of_robot = heard & INPUTS.keys()
    types = {subscribes[topic] for topic in heard}
    likely = (topic for topic, kind in INPUTS.items() if kind in types and topic != m.topic)
    m.likely_input = next(likely, '/odom')
    wrong = [topic for topic in m.inputs_of_robot
             if subscribes[topic] not in ('', '*', OLD_TF, INPUTS[topic])]
    m.wrong_inputs = quoting.listed(
        f'{topic} as {subscribes[topic]}, but it is {INPUTS[topic]}' for topic in wrong)
