"""Measures of a Run in which the node drives the robot."""

import math
import statistics

from odometry_common.angles import wrap_to_pi
from odometry_common.rest import is_slow
from sim_turtlebot.kobuki import MAX_ANGULAR_SPEED

from odometry_tools.check.controller import find_controller
from odometry_tools.check.run import ZERO
from odometry_tools.check.scenarios import GOAL
from odometry_tools.runs.quoting import listed

CLOSE = 0.05  # m, from the goal at rest
OVERSHOOT = 0.25  # m of path beyond the goal, for a node that comes back to it
AT_TARGET = 3.0  # degrees
DETOUR = 85.0  # degrees of overshooting and back; the longer way round is at least 90 longer
SLACK = 0.03  # s of simulated time
PACED_SLACK = 0.1  # s of wall time
MOVED = 1e-4  # m or rad; even the slowest command moves the robot more before the watchdog stops it
RINGING = 5.0  # s at the end of a run, in which a controller should have settled
STILL = 2.0  # s at the end of a run, in which the heading should stay
LONGEST_PERIOD = 1.0  # s; a zero may be two periods of the loop late, each at most this long
FLIPS = 4  # changes of sign allowed in those RINGING s
CEASED = 0.55  # s without a command, a little less than the watchdog's
STOP_FITS = 0.06  # m between where the node stopped and where a mistake stops


def measure_drive(m, run):
    """Measure what both driving exercises share."""
    m.start = run.odometry[run.start]
    m.end = run.odometry[-1]
    m.start_heading = math.degrees(wrap_to_pi(m.start.yaw))
    m.heading = math.degrees(wrap_to_pi(m.end.yaw))
    m.turned = math.degrees(m.end.turned)
    m.has_moved = max(m.end.way, m.end.turned) > MOVED
    m.is_still = m.end.way < 0.03 and m.turned < 3
    m.at = '' if m.is_still else f' after {m.end.way:.2f} m and {m.turned:.0f} degrees'
    m.useless = listed(name for command in m.commands for name in command.useless)
    m.mux = listed(command.topic for command in m.commands if command.topic != 'cmd_vel')
    m.moves = [command for command in m.commands if command.moves]
    m.drives = any(command.drives for command in m.moves)
    m.turns = any(abs(command.angular) > ZERO for command in m.moves)
    m.fastest = max((abs(command.linear) for command in m.moves), default=0.0)
    m.seconds = 0.0
    m.has_ceased = False
    if m.moves:
        _measure_last_command(m, run)
    m.drove_again = False
    if run.interrupted is not None:
        _measure_after_ctrl_c(m, run)


def _measure_last_command(m, run):
    """Measure how the commands end: with a zero, in silence, or not at all."""
    times = [command.time for command in m.moves]
    intervals = [after - before for before, after in zip(times, times[1:])]
    m.own_period = statistics.median_low(intervals or [0.0])
    last = m.commands[-1]
    is_turn = abs(last.angular) > abs(last.linear) or not m.drives
    m.last_word = f'{last.angular:.2g} rad/s' if is_turn else f'{last.linear:.2g} m/s'
    if not last.moves:
        m.stop = _first_after(m.commands, lambda command: command.moves)
    m.silence = (m.stop.time if m.stop else run.now) - m.moves[-1].time
    m.has_ceased = last.moves and m.silence > max(CEASED, 1.5 * m.own_period)
    m.at_last = _pose_at(run, last.time)
    m.turned_at_last = math.degrees(m.at_last.turned - m.start.turned)
    m.seconds = run.now - m.moves[0].time


def _measure_after_ctrl_c(m, run):
    """Measure for how long the node drove on, and whether it sent a zero before."""
    m.driven_on = m.moves[-1].time - run.interrupt_time
    commands = m.commands[run.interrupted:]
    m.drove_again = any(
        after.moves and not before.moves
        for before, after in zip(commands, commands[1:]))


def _first_after(commands, holds):
    """Return the command after the last one for which a function holds."""
    return commands[max(number for number, command in enumerate(commands) if holds(command)) + 1]


def _pose_at(run, time):
    """Return the latest Pose at a time (s)."""
    earlier = (pose for pose in reversed(run.odometry) if pose.time <= time + 1e-6)
    return next(earlier, run.odometry[0])


def measure_distance(m, run):
    """Measure a drive of two metres."""
    m.bound = 2 * max(1 / m.rate, min(m.own_period, LONGEST_PERIOD)) + SLACK
    if not run.pace.lockstep:
        m.bound += PACED_SLACK * run.pace.real_time_factor
    m.share = m.end.way / GOAL
    m.step = m.fastest / m.rate
    m.is_short = m.end.way < GOAL - CLOSE
    m.was_there = not m.is_short
    m.reached = f'{m.end.way:.2f} m'
    has_come_to_rest = is_slow(m.end.linear, m.end.angular)
    m.stays = 'rests' if has_come_to_rest else 'was, when this was ended,'
    if m.drives:
        _measure_passing(m, run)
        if m.stop:
            _measure_stop(m, run)


def _measure_passing(m, run):
    """Measure when the robot passed two metres, and where the node stopped before it drove on."""
    passings = (pose.time for pose in run.odometry if pose.way >= GOAL - 1e-3)
    m.crossing = next(passings, run.now)
    last = max(command.time for command in m.moves if command.drives)
    m.pause = next((_pose_at(run, command.time) for command in m.commands
                    if not command.drives and m.crossing <= command.time < last), None)


def _measure_stop(m, run):
    """Measure when and where the node stopped driving; it may turn afterwards."""
    m.stop = _first_after(m.commands, lambda command: command.drives)
    m.at_stop = _pose_at(run, m.stop.time)
    m.driven = m.stop.time - m.moves[0].time
    m.delay = m.stop.time - m.crossing
    is_in_time = m.delay <= m.bound or m.end.way <= GOAL + CLOSE
    from_start = math.dist(m.end[1:3], m.start[1:3])
    is_back = abs(from_start - GOAL) <= CLOSE and m.end.way <= GOAL + OVERSHOOT
    m.passed = is_slow(m.end.linear) and not m.is_short and (is_in_time or is_back)
    if m.end.way - from_start > CLOSE:
        m.reached = f'{from_start:.2f} m from the start ({m.reached} of way)'
    m.moved_x = abs(m.at_stop.x - m.start.x)
    m.moved_y = abs(m.at_stop.y - m.start.y)
    # How far the robot stopped from where each mistake stops.
    off_by_one_axis = min(abs(m.moved_x - GOAL), abs(m.moved_y - GOAL))
    off_by_sum = abs(m.moved_x + m.moved_y - GOAL)
    off_by_place = math.hypot(m.at_stop.x - GOAL, m.at_stop.y)
    m.fits = {
        name for name, off in (
            ('one_axis', off_by_one_axis),
            ('sum_of_axes', off_by_sum),
            ('place', off_by_place))
        if off < STOP_FITS}


def measure_heading(m, run):
    """Measure a turn to a heading."""
    after_reset = run.odometry[run.start:]
    target = math.radians(m.target)
    errors = [
        (pose.time, math.degrees(wrap_to_pi(target - pose.yaw)))
        for pose in after_reset]
    _, first = errors[0]
    _, last = errors[-1]
    m.shortest = abs(first)
    m.heading_error = abs(last)
    m.is_short = m.heading_error > AT_TARGET
    m.was_there = not m.is_short or bool(m.moves) and (
        abs(math.degrees(wrap_to_pi(target - m.at_last.yaw))) < 2 * AT_TARGET)
    m.turned = math.degrees(m.end.turned - m.start.turned)
    m.net = math.degrees(m.end.turn - m.start.turn)
    m.share = m.net / (first or 1.0)
    # Beyond the target, to which it went by the shorter way.
    m.swing = max((abs(error) for _, error in errors if error * first < 0), default=0.0)
    m.goes_shorter_way = abs(abs(m.net) - m.shortest) < DETOUR / 2
    _measure_swings(m, run)
    arrival = max((time for time, error in errors if abs(error) >= AT_TARGET), default=0.0)
    m.arrival = arrival - m.moves[0].time if m.moves else 0.0
    still = [error for time, error in errors if time > run.now - STILL]
    m.is_settled = max(still) - min(still) < 1.0
    is_there = max(map(abs, still)) <= AT_TARGET
    is_direct = m.turned <= m.shortest + DETOUR
    m.drives_on = not is_slow(m.end.linear)
    m.passed = (is_there and is_direct
                and not (m.drives_on or m.rings or m.has_ceased))
    m.follows, m.gain, m.zero = find_controller(run, m.moves)


def _measure_swings(m, run):
    """Measure the speeds of the commands, and how often their sign changes.

    `chatter` is their size (rad/s) since the first change, if it is always the same.
    """
    swings = [command for command in m.moves if command.swings]
    flips = [
        after.time for before, after in zip(swings, swings[1:])
        if before.angular * after.angular < 0]
    m.flips = len(flips)
    late_flips = [time for time in flips if time > run.now - RINGING]
    m.rings = len(late_flips) > FLIPS
    sizes = {round(abs(command.angular), 3) for command in m.moves
             if flips and command.time >= flips[0]}
    m.chatter = sizes.pop() if len(sizes) == 1 else 0.0
    fastest = max((abs(command.angular) for command in m.moves), default=0.0)
    m.step = math.degrees(min(fastest, MAX_ANGULAR_SPEED)) / m.rate
