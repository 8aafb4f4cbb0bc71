"""What a Run shows, in numbers and words: rules, hints and their sentences speak of these by name."""

import math
from types import SimpleNamespace

from odometry_tools.check import quoting
from odometry_tools.check.detector import measure_detector
from odometry_tools.check.drive_measures import measure_distance, measure_drive, measure_heading

FLOOD = 200  # commands a simulated second
# What a node may know of the robot, and its types.
INPUTS = {'/odom': 'nav_msgs/Odometry', '/base_pose_ground_truth': 'nav_msgs/Odometry',
          '/moved_distance': 'std_msgs/Float64', '/tf': 'tf2_msgs/TFMessage', '/joint_states': 'sensor_msgs/JointState',
          '/mobile_base/sensors/imu_data': 'sensor_msgs/Imu'}


def measure(run, exercise):
    """Return a namespace of what a Run shows of an Exercise."""
    m = SimpleNamespace(run=run, scenario=run.scenario, exercise=exercise, topic=exercise.topic, type=exercise.type,
                        commands=run.commands, passed=False, rate=run.scenario.odom_rate, target=exercise.target)
    m.quantity, m.unit = ('distance', 'm') if exercise.target is None else ('heading', 'degrees')
    output = quoting.plain(run.output)
    m.error, m.said = quoting.error_in(output), quoting.last_line(output)
    m.callback_error = m.error if 'bad callback' in output else ''
    died = quoting.DIED.search(output)
    m.status = int(died[1]) if died else run.status
    m.how = '' if m.status is None else quoting.how_ended(m.status)
    m.lost_node = next((line for line in output.split('\n') if 'cannot launch node of type' in line), '')
    published = [value for _, value in run.moved] if exercise.route else [
        speed for command in run.commands for speed in (command.linear, command.angular)]
    m.is_silent = not published or bool(exercise.route and not run.legs)
    m.is_finite = all(map(math.isfinite, published))
    m.keeps_failing = output.count('bad callback') > len(run.moved or run.commands)
    m.floods = len(run.commands) > FLOOD * max(run.now, 1.0)
    m.at = ''
    m.outputs = _words(topic for topic, kind in run.publishes.items() if kind == m.type and topic != m.topic)
    m.output_type = run.publishes.get(m.topic) or m.type
    heard = run.subscribes.keys() - {'/clock', '/rosout'}
    m.inputs = _words(heard) or 'nothing'
    m.hears_robot = bool(heard & INPUTS.keys())
    m.wrong_inputs = _words(f'{topic} as {run.subscribes[topic]}' for topic in heard & INPUTS.keys()
                            if run.subscribes[topic] not in ('', '*', INPUTS[topic]))
    if exercise.route and m.is_finite:
        measure_detector(m, run)
    elif run.odometry and m.is_finite:
        measure_drive(m, run)
        (measure_distance if exercise.target is None else measure_heading)(m, run)
        if run.interrupted is not None:
            m.passed = run.ends and not run.commands[-1].moves
    return m


def _words(names):
    return ', '.join(sorted(set(names)))
