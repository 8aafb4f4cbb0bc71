"""What a Run shows, in numbers and words: the rules and their sentences speak of these by name."""

import math
import re
import statistics
from types import SimpleNamespace

from odometry_common.angles import wrap_to_pi

from odometry_tools.check.bench import COMMANDS
from odometry_tools.check.detector import measure_detector
from odometry_tools.check.scenarios import GOAL

CLOSE = 0.05  # m, of rest from the goal
AT_TARGET = 3.0  # degrees
SLACK, PACED_SLACK = 0.03, 0.1  # s; s of wall time
REST = 2e-3  # m/s and rad/s
SWING = 0.02  # rad/s; a smaller command is no swing
END, STILL = 5.0, 2.0  # s at the end of a run, in which a controller has settled, a heading stays
CEASED = 0.55  # s
ERROR = re.compile(r'^(?:\w+\.)*(\w*(?:Error|Exception)): ?(.*)$', re.MULTILINE)
PLACE = re.compile(r'File "([^"]+)", line (\d+)')
NOT_USER_CODE = re.compile('/usr/|/opt/|dist-packages|site-packages|<frozen|<string>')
PROCESS = re.compile(r' \(process[^)]*\)')


def measure(run, exercise):
    """Return a namespace of what a Run shows of an Exercise."""
    m = SimpleNamespace(run=run, name=run.scenario.name, status=run.status, commands=run.commands,
                        rate=run.scenario.odom_rate, sent=max(run.sent, len(run.commands)),
                        moves=[command for command in run.commands if command.moves])
    m.s = '' if m.sent == 1 else 's'
    m.duration = max(run.now, 1e-9)
    factor = run.pace.real_time_factor
    m.pace = 'in real time' if factor == 1 else f'at {factor:g} times real time'
    m.few, m.unawaited = 10 * m.duration, PROCESS.sub('', run.unawaited or '')
    m.ended = run.status is not None and run.interrupted is None
    m.bad_callback = 'bad callback' in run.output
    m.error, m.line = error_in(run.output)
    m.crashed = m.ended and m.status != 0 and not (m.error or '').startswith('ROSInterruptException')
    last_words = run.output.split('\n')[-2:-1] or ['it said nothing']
    m.why = f'{m.error}, line {m.line}' if m.error else last_words[0]
    m.topic, m.wanted, heard = (('/moved_distance', 'std_msgs/Float64', run.moved) if exercise.route else
                                ('/cmd_vel', 'geometry_msgs/Twist', run.commands))
    m.silent = not heard
    m.refused = m.topic in run.refused
    m.type = run.types.get(m.topic) if m.topic in run.publishes else None
    m.elsewhere = _words(topic for topic in run.publishes if 'Twist' in run.types.get(topic, '')
                         and topic.lstrip('/') not in COMMANDS)
    m.unheard = _words(topic for topic in run.subscribes - run.published - {'/tf', '/tf_static'}
                       if not topic.startswith('/rosout'))
    m.at, m.passed = '', False
    if exercise.route:
        measure_detector(m, run)
    elif run.odometry:
        _measure_drive(m, run)
        (_measure_distance if exercise.target is None else _measure_heading)(m, run, exercise.target)
        if run.interrupted is not None:
            m.passed = run.ends and not run.commands[-1].moves
    m.passed = m.passed and not m.crashed
    return m


def error_in(output):
    """Return the last error that Python reported, and the line of the learner's file; both or None."""
    found = [*ERROR.finditer(output)]
    if not found:
        return None, None
    lines = [line for path, line in PLACE.findall(output[:found[-1].start()]) if not NOT_USER_CODE.search(path)]
    return f'{found[-1][1]}: {found[-1][2]}'.rstrip(': '), lines[-1] if lines else '?'


def _words(names):
    return ', '.join(sorted(set(names)))


def _measure_drive(m, run):
    """Measure what both driving exercises have in common."""
    poses = run.odometry
    m.path = [0.0]
    for before, pose in zip(poses, poses[1:]):
        m.path.append(m.path[-1] + math.dist(before[1:3], pose[1:3]))
    m.gone, m.x, m.y = m.path[-1], poses[0].x, poses[0].y
    m.turned = math.degrees(sum(abs(pose.yaw - before.yaw) for before, pose in zip(poses, poses[1:])))
    m.start, m.yaw = (math.degrees(wrap_to_pi(pose.yaw)) for pose in (poses[0], poses[-1]))
    m.at = f' after {m.gone:.2f} m and {m.turned:.0f} degrees'
    m.stays = m.gone < 0.03 and m.turned < 3
    m.short_by = 0.0 if m.turned > 10 or run.interrupted is not None else GOAL - m.gone
    m.useless = _words(name for command in run.commands for name in command.useless)
    m.mux = _words(command.topic for command in m.moves if command.topic != 'cmd_vel')
    speeds = [max(command.linear, command.angular, key=abs) for command in m.commands]
    m.first = next((speed for command, speed in zip(m.commands, speeds) if command.moves), 0.0)
    m.last = abs(speeds[-1]) if speeds else 0.0
    m.last_word = '' if not speeds else (
        f'{speeds[-1]:.2f} {"m/s" if speeds[-1] == m.commands[-1].linear else "rad/s"}')
    m.top_speed, m.top_turn = (max((abs(command[axis]) for command in m.moves), default=0.0)
                               for axis in (1, 2))
    m.moves_at_end = bool(m.moves) and m.commands[-1].moves
    m.ceased = m.moves_at_end and run.now - m.commands[-1].time > CEASED
    m.stop = None if m.moves_at_end or not m.moves else next(
        command.time for command in m.commands[m.commands.index(m.moves[-1]):] if not command.moves)
    m.driven = (m.stop or m.commands[-1].time) - m.moves[0].time if m.moves else 0.0


def _measure_distance(m, run, _target):
    """Measure how a robot drives two metres."""
    poses = run.odometry
    m.moved_x, m.moved_y = (abs(poses[-1][axis] - poses[0][axis]) for axis in (1, 2))
    m.commanded = sum(abs(before.linear) * min(0.6, after.time - before.time)
                      for before, after in zip(m.commands, m.commands[1:]))
    intervals = [after.time - before.time for before, after in zip(m.moves, m.moves[1:])]
    period = max(1 / run.scenario.odom_rate, statistics.median(intervals or [0.0]))
    m.bound = 2 * period + SLACK + (0 if run.pace.lockstep else PACED_SLACK * run.pace.real_time_factor)
    crossed = next((pose.time for pose, gone in zip(poses, m.path) if gone >= GOAL - 1e-3), None)
    m.at_stop = m.gone if m.stop is None else next(
        (gone for pose, gone in zip(reversed(poses), reversed(m.path)) if pose.time <= m.stop + 1e-6), 0.0)
    m.delay = 0.0 if None in (m.stop, crossed) else m.stop - crossed
    m.early = m.gone < GOAL - CLOSE
    m.step = m.top_speed / run.scenario.odom_rate
    m.passed = (m.stop is not None and abs(poses[-1].linear) < REST and not m.early
                and (m.delay <= m.bound or m.gone <= GOAL + CLOSE))


def _measure_heading(m, run, target):
    """Measure how a robot turns to a heading (degrees)."""
    poses = run.odometry
    errors = [math.degrees(wrap_to_pi(math.radians(target) - pose.yaw)) for pose in poses]
    m.error_at_start, m.shortest, m.off = errors[0], abs(errors[0]), abs(errors[-1])
    m.net = math.degrees(poses[-1].yaw - poses[0].yaw)
    m.spins = abs(m.net) > 540
    swings = [command for command in m.commands if abs(command.angular) > SWING]
    flips = [after.time for before, after in zip(swings, swings[1:]) if before.angular * after.angular < 0]
    m.flips, m.rings = len(flips), sum(time > run.now - END for time in flips) > 4
    speeds = [abs(command.angular) for command in m.moves]
    m.is_constant = len({round(speed, 3) for speed in speeds if speed > SWING}) <= 2
    m.typical, m.least = (statistics.median(speeds), min(speeds)) if speeds else (0.0, 0.0)
    m.turn_step = math.degrees(m.typical) / run.scenario.odom_rate
    m.arrival = max((pose.time for pose, error in zip(poses, errors) if abs(error) >= AT_TARGET), default=0.0)
    m.arrival -= m.moves[0].time if m.moves else 0.0
    still = [error for pose, error in zip(poses, errors) if pose.time > run.now - STILL]
    m.settled = max(still) - min(still) < 1.0
    m.passed = (max(map(abs, still)) <= AT_TARGET and m.turned <= m.shortest + 90 and not m.rings
                and not m.ceased)
