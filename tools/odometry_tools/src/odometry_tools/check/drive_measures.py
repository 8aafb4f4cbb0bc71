"""What a Run shows of a robot that a node drives."""

import math
import statistics

import numpy
from odometry_common.angles import wrap_to_pi

from odometry_tools.check.run import ZERO
from odometry_tools.check.scenarios import GOAL, PERIOD

CLOSE = 0.05  # m, of rest from the goal
AT_TARGET = 3.0  # degrees
DETOUR = 60.0  # degrees, of overshooting
SLACK, PACED_SLACK = 0.03, 0.1  # s; s of wall time
REST = 2e-3  # m/s and rad/s
SWING = 0.02  # rad/s; a smaller command is no swing
RINGING, STILL = 5.0, 2.0  # s at the end of a run, in which a controller has settled, a heading stays
CEASED = 0.55  # s
FITS = 0.04  # m
FEWEST, RESIDUAL = 8, 0.003  # commands that show a gain, and the share of them that it may leave


def measure_drive(m, run):
    """Measure what both driving exercises have in common."""
    m.start, m.end = run.odometry[run.start], run.odometry[-1]
    m.start_heading, m.heading = (math.degrees(wrap_to_pi(pose.yaw)) for pose in (m.start, m.end))
    m.turned = math.degrees(m.end.turned)
    m.is_still = m.end.way < 0.03 and m.turned < 3
    m.at = '' if m.is_still else f' after {m.end.way:.2f} m and {m.turned:.0f} degrees'
    m.useless = ', '.join(sorted({name for command in m.commands for name in command.useless}))
    m.mux = ', '.join(sorted({command.topic for command in m.commands if command.topic != 'cmd_vel'}))
    m.moves = [command for command in m.commands if command.moves]
    m.drives, m.turns = (any(abs(command[axis]) > ZERO for command in m.moves) for axis in (1, 2))
    m.seconds = m.driven = 0.0
    m.has_ceased = False
    m.stop = None
    if m.moves:
        last = m.commands[-1]
        m.last_word = f'{last.angular:.2g} rad/s' if abs(last.angular) > abs(last.linear) else f'{last.linear:.2g} m/s'
        m.has_ceased = last.moves and run.now - last.time > CEASED
        m.stop = None if last.moves else m.commands[m.commands.index(m.moves[-1]) + 1]
        m.at_last = _pose_at(run, last.time)
        m.turned_at_last = math.degrees(m.at_last.turned - m.start.turned)
        m.seconds = run.now - m.moves[0].time
        m.driven = (m.stop or last).time - m.moves[0].time


def _pose_at(run, time):
    """Return the latest Pose at a time (s)."""
    return next((pose for pose in reversed(run.odometry) if pose.time <= time + 1e-6), run.odometry[0])


def measure_distance(m, run):
    """Measure how a robot drives two metres."""
    intervals = [after.time - before.time for before, after in zip(m.moves, m.moves[1:])]
    period = max(1 / m.rate, statistics.median(intervals or [0.0]))
    m.bound = 2 * period + SLACK + (0 if run.pace.lockstep else PACED_SLACK * run.pace.real_time_factor)
    m.share = m.end.way / GOAL
    m.step = max((abs(command.linear) for command in m.moves), default=0.0) / m.rate
    m.is_early = m.end.way < GOAL - CLOSE
    if m.stop is None:
        return
    m.at_stop = _pose_at(run, m.stop.time)
    crossing = next((pose.time for pose in run.odometry if pose.way >= GOAL - 1e-3), m.stop.time)
    m.delay = m.stop.time - crossing
    m.passed = (abs(m.end.linear) < REST and not m.is_early
                and (m.delay <= m.bound or m.end.way <= GOAL + CLOSE))
    x, y = m.at_stop.x, m.at_stop.y
    m.moved_x, m.moved_y = abs(x - m.start.x), abs(y - m.start.y)
    wrong_distances = {'one_axis': min(abs(m.moved_x - GOAL), abs(m.moved_y - GOAL)),
                       'sum_of_axes': abs(m.moved_x + m.moved_y - GOAL), 'place': math.hypot(x - GOAL, y)}
    m.fits = {name for name, distance in wrong_distances.items() if distance < FITS}


def measure_heading(m, run):
    """Measure how a robot turns to a heading (degrees)."""
    after_reset = run.odometry[run.start:]
    errors = [math.degrees(wrap_to_pi(math.radians(m.target) - pose.yaw)) for pose in after_reset]
    m.shortest, m.heading_error = abs(errors[0]), abs(errors[-1])
    m.turned = math.degrees(m.end.turned - m.start.turned)
    m.net = math.degrees(m.end.turn - m.start.turn)
    m.share = m.net / (errors[0] or 1.0)
    swings = [command for command in m.moves if abs(command.angular) > SWING]
    m.turns_away = bool(swings) and m.scenario.yaw == 0.0 and swings[0].angular < 0
    flips = [after.time for before, after in zip(swings, swings[1:]) if before.angular * after.angular < 0]
    m.flips, m.rings = len(flips), sum(time > run.now - RINGING for time in flips) > 4
    speed = statistics.median([abs(command.angular) for command in m.moves] or [0.0])
    m.step = math.degrees(speed) / m.rate
    arrival = max((pose.time for pose, error in zip(after_reset, errors) if abs(error) >= AT_TARGET), default=0.0)
    m.arrival = arrival - m.moves[0].time if m.moves else 0.0
    still = [error for pose, error in zip(after_reset, errors) if pose.time > run.now - STILL]
    m.is_settled = max(still) - min(still) < 1.0
    m.passed = (max(map(abs, still)) <= AT_TARGET and m.turned <= m.shortest + DETOUR and not m.rings
                and not m.has_ceased)
    m.follows, m.gain, m.zero = _controller(run, m.moves)


def _controller(run, moves):
    """Return which angle the commands are proportional to, by what gain (1/s), and where they are zero (degrees).

    The angle is '' if none fits, or more than one does.
    """
    time, yaw = numpy.array([(pose.time, pose.yaw) for pose in run.odometry]).T
    sent, speed = numpy.array([(command.time, command.angular) for command in moves] or [(0.0, 0.0)]).T
    is_free = abs(speed) < 0.99 * abs(speed).max()  # of the node's own limit
    found = {}
    for delay in (0, PERIOD, 1 / run.scenario.odom_rate):
        seen = yaw[numpy.searchsorted(time, sent - delay + 1e-6).clip(1) - 1]
        for name, angle in _angles(seen).items():
            if is_free.sum() >= FEWEST and name not in found:
                slope, offset = numpy.polyfit(angle[is_free], speed[is_free], 1)
                residual = abs(slope * angle + offset - speed)[is_free].max()
                if slope < 0 and residual < RESIDUAL * numpy.ptp(speed[is_free]):
                    found[name] = -slope, math.degrees(-offset / slope)
    if len(found) != 1:
        return '', 0.0, 0.0
    (name, (gain, zero)), = found.items()
    return name, gain, zero


def _angles(yaw):
    """Return what a learner may take for the heading, where it is not the same."""
    angles = {'yaw_to_360': yaw % (2 * math.pi), 'half_circle': numpy.arcsin(numpy.sin(yaw)),
              'quaternion': numpy.sin(yaw / 2)}
    return {'yaw': yaw, **{name: angle for name, angle in angles.items() if not numpy.allclose(angle, yaw)}}
