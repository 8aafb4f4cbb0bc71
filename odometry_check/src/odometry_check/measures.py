"""What a Run shows, in numbers and words; the rules speak of these by name."""

import math
import re
import statistics
from types import SimpleNamespace

from odometry_common.geometry import wrap_to_pi

from odometry_check.bench import COMMANDS
from odometry_check.detector import measure_detector
from odometry_check.scenarios import GOAL

CLOSE = 0.05  # m, of rest from the goal
AT_TARGET = 3.0  # degrees
SLACK, PACED_SLACK = 0.03, 0.1  # s; s of wall time
REST = 2e-3  # m/s and rad/s
RINGING = 0.02  # rad/s; a smaller command is no swing
END = 5.0  # s of a run, in which a controller has settled
ERROR = re.compile(r'^(?:\w+\.)*(\w*(?:Error|Exception)): ?(.*)$', re.MULTILINE)
PLACE = re.compile(r'File "([^"]+)", line (\d+)')
PROCESS = re.compile(r' \(process[^)]*\)')
NOT_HERS = re.compile('/usr/|/opt/|dist-packages|site-packages|<frozen|<string>')


def measure(run, exercise):
    """Return a namespace of what a Run shows of an Exercise."""
    m = SimpleNamespace(run=run, name=run.scenario.name, odometries=len(run.odometry),
                        commands=run.commands, status=run.status, sent=max(run.sent, len(run.commands)),
                        moves=[command for command in run.commands if command.moves])
    m.s = '' if m.sent == 1 else 's'
    m.duration = max(run.now, 1e-9)
    m.bad_callback = 'bad callback' in run.output
    m.error, m.line = error_in(run.output)
    m.ended = run.status is not None and run.interrupted is None
    last_words = run.output.strip().splitlines()[-1:] or ['it said nothing']
    m.why = f'{m.error}, line {m.line}' if m.error else last_words[0]
    m.topic, m.wanted = (('/moved_distance', 'std_msgs/Float64') if exercise.route else
                         ('/cmd_vel', 'geometry_msgs/Twist'))
    m.silent = not (run.moved if exercise.route else run.commands)
    m.refused = m.silent and m.topic in run.refused
    m.elsewhere = ', '.join(sorted(topic for topic in run.publishes if 'Twist' in run.types.get(topic, '')
                                   and topic.lstrip('/') not in COMMANDS))
    m.mux = ', '.join(sorted({command.topic for command in m.moves} - {'cmd_vel'}))
    m.unheard = ', '.join(sorted(topic for topic in run.subscribes - run.published - {'/tf', '/tf_static'}
                                 if not topic.startswith('/rosout')))
    m.type = run.types.get(m.topic) if m.topic in run.publishes else None
    m.few, m.pace, m.unawaited = 10 * m.duration, run.pace.real_time_factor, PROCESS.sub('', run.unawaited or '')
    if exercise.route:
        measure_detector(m, run)
    elif run.odometry:
        _measure_drive(m, run)
        (_measure_distance if exercise.target is None else _measure_heading)(m, run, exercise.target)
        if run.interrupted is not None:
            m.passed = run.ends and not run.commands[-1].moves
    else:
        m.passed = False
    m.passed = m.passed and not (m.ended and m.status != 0)
    return m


def error_in(output):
    """Return the last error that Python reported, and the line of the learner's file; both or None."""
    found = [*ERROR.finditer(output)]
    if not found:
        return None, None
    places = [number for path, number in PLACE.findall(output[:found[-1].start()])
              if not NOT_HERS.search(path)]
    return f'{found[-1][1]}: {found[-1][2]}'.rstrip(': '), places[-1] if places else '?'


def _measure_drive(m, run):
    """Measure what both driving exercises have in common."""
    poses = run.odometry
    m.path = [0.0]
    for before, pose in zip(poses, poses[1:]):
        m.path.append(m.path[-1] + math.hypot(pose.x - before.x, pose.y - before.y))
    m.gone = m.path[-1]
    m.turned = math.degrees(sum(abs(pose.yaw - before.yaw) for before, pose in zip(poses, poses[1:])))
    m.yaw = math.degrees(wrap_to_pi(poses[-1].yaw))
    m.start = math.degrees(wrap_to_pi(poses[0].yaw))
    m.at = f' after {m.gone:.2f} m and {m.turned:.0f} degrees'
    m.x, m.y = poses[0].x, poses[0].y
    last = run.commands[-1] if run.commands else None
    m.last = max(abs(last.linear), abs(last.angular)) if last else 0.0
    m.last_word = (f'{last.linear:.2f} m/s' if abs(last.linear) > abs(last.angular) else
                   f'{last.angular:.2f} rad/s') if last else ''
    m.short_by = 0.0 if m.turned > 10 or run.interrupted is not None else GOAL - m.gone
    m.stays = m.gone < 0.03 and m.turned < 3
    m.useless = ', '.join(sorted({name for command in run.commands for name in command.useless}))
    m.first = next((max(command.linear, command.angular, key=abs) for command in m.moves), 0.0)
    intervals = [after.time - before.time for before, after in zip(m.moves, m.moves[1:])]
    m.period = max(1 / run.scenario.odom_rate, statistics.median(intervals or [0.0]))
    m.moves_at_end = bool(m.moves) and m.commands[-1].moves
    m.ceased = m.moves_at_end and run.now - m.commands[-1].time > 0.55
    m.at_rest = max(abs(poses[-1].linear), abs(poses[-1].angular)) < REST
    m.stop = None if m.moves_at_end or not m.moves else next(
        command.time for command in m.commands[m.commands.index(m.moves[-1]):] if not command.moves)
    m.driven = (m.stop or m.commands[-1].time) - m.moves[0].time if m.moves else 0.0
    m.commanded = sum(before.linear * min(0.6, after.time - before.time)
                      for before, after in zip(m.commands, m.commands[1:]))
    m.gaps = max(intervals, default=0.0)
    m.top_speed = max((abs(command.linear) for command in m.moves), default=0.0)
    m.top_turn = max((abs(command.angular) for command in m.moves), default=0.0)


def _at(run, values, time):
    """Return the value of the latest odometry at a time (s)."""
    number = sum(pose.time <= time + 1e-6 for pose in run.odometry)
    return values[max(0, number - 1)]


def _measure_distance(m, run, _target):
    """Measure how a robot drives two metres."""
    x, y = (abs(run.odometry[-1][axis] - run.odometry[0][axis]) for axis in (1, 2))
    m.moved_x, m.moved_y, m.axes = x, y, x + y
    m.crossed = next((pose.time for pose, gone in zip(run.odometry, m.path) if gone >= GOAL - 1e-3), None)
    m.at_stop = _at(run, m.path, m.stop) if m.stop is not None else m.gone
    m.delay = m.stop - m.crossed if m.stop is not None and m.crossed is not None else 0.0
    m.bound = 2 * m.period + SLACK + PACED_SLACK * run.pace.real_time_factor * (not run.pace.lockstep)
    m.early = m.gone < GOAL - CLOSE
    m.step = m.top_speed / run.scenario.odom_rate
    m.passed = (m.stop is not None and m.at_rest and not m.early
                and (m.delay <= m.bound or m.gone <= GOAL + CLOSE))


def _measure_heading(m, run, target):
    """Measure how a robot turns to a heading (degrees)."""
    target = math.radians(target)
    m.typical = statistics.median(abs(command.angular) for command in m.moves) if m.moves else 0.0
    errors = [math.degrees(wrap_to_pi(target - pose.yaw)) for pose in run.odometry]
    m.error_at_end, m.error_at_start = errors[-1], errors[0]
    m.off = abs(m.error_at_end)
    m.turn_step = math.degrees(m.typical) / run.scenario.odom_rate
    m.shortest, m.net = abs(errors[0]), math.degrees(run.odometry[-1].yaw - run.odometry[0].yaw)
    signs = [(command.time, command.angular > 0) for command in m.commands if abs(command.angular) > RINGING]
    flips = [time for (_, before), (time, after) in zip(signs, signs[1:]) if before != after]
    m.flips = len(flips)
    m.rings = sum(time > run.now - END for time in flips) > 4
    m.steady = {round(abs(command.angular), 3) for command in m.moves if abs(command.angular) > RINGING}
    m.is_constant = len(m.steady) <= 2
    m.least = min((abs(command.angular) for command in m.moves), default=0.0)
    m.arrival = max((pose.time for pose, error in zip(run.odometry, errors) if abs(error) >= AT_TARGET),
                    default=0.0)
    m.long_way = m.turned > m.shortest + 90
    still = [error for pose, error in zip(run.odometry, errors) if pose.time > run.now - 2.0]
    m.settled = max(still) - min(still) < 1.0
    m.near = m.off < 25
    m.arrival -= m.moves[0].time if m.moves else 0.0
    m.passed = (max(map(abs, still)) <= AT_TARGET and not m.long_way and not m.rings
                and not (m.moves_at_end and m.ceased))
