"""What the check says of a robot's behaviour, without ROS: each node is a function of the odometry."""

import math

import pytest
from behaviours import (
    RIGHT_ANGLE,
    by_time,
    counting,
    drives_again,
    driving,
    fixed_time,
    from_origin,
    heading_to_360,
    narrow_window,
    once,
    once_a_second,
    one_step,
    overshooting,
    place_by_speed,
    rarely,
    remembering,
    rest_between,
    rounded,
    silent_halfway,
    spins_at_the_goal,
    to_point,
    turn_by,
    turn_by_time,
    turning,
    way,
    while_moving,
    without_zero,
    wrong_derivative,
)
from kinematic_robot import drive, verdicts
from learners import BAD_CALLBACK, ERROR
from odometry_common.angles import wrap_to_pi
from odometry_tools.check.judging import verdicts_on
from odometry_tools.check.run import Command
from odometry_tools.check.scenarios import EXERCISES

EVERYWHERE = 'plain', 'moved_start', 'odom_5hz', 'slow_base'
ON_THE_ROUTE = 'route', *EVERYWHERE[1:]
# The node, and the rule and hint of the scenarios that are not passed.
CASES = {
    'two_meters': {
        'right': (driving(way), {}),
        'right, fast': (driving(way, 1.0), {}),
        'right, with a rest': (remembering(rest_between), {}),
        'right, overshoots': (remembering(overshooting), {}),
        'right, spins at the goal': (remembering(spins_at_the_goal), {}),
        'fixed time': (remembering(fixed_time), {'odom_5hz': 'passed_by slow_odometry'}),
        'position': (driving(lambda start, pose: pose.x), {'moved_start': 'all_zero start'}),
        'one axis': (driving(lambda start, pose: abs(pose.x - start.x)), {'moved_start': 'late one_axis'}),
        'sum': (driving(lambda start, pose: abs(pose.x - start.x) + abs(pose.y - start.y)),
                {'moved_start': 'early sum_of_axes'}),
        'from the origin': (driving(lambda start, pose: math.hypot(pose.x, pose.y) - math.hypot(start.x, start.y)),
                            {'moved_start': 'passed_by start'}),
        'a point': (remembering(to_point), {'moved_start': 'early place'}),
        'squares': (driving(lambda start, pose: way(start, pose)**2), dict.fromkeys(EVERYWHERE, 'early')),
        'early': (driving(lambda start, pose: way(start, pose) + 0.1), dict.fromkeys(EVERYWHERE, 'early')),
        'equality': (remembering(lambda memory, pose: (0.3, 0.0)), dict.fromkeys(EVERYWHERE, 'passed_by')),
        'window': (remembering(narrow_window), {'odom_5hz': 'passed_by slow_odometry'}),
        'time': (remembering(by_time), {'slow_base': 'early open_loop'}),
        'no zero': (remembering(without_zero), dict.fromkeys(EVERYWHERE, 'ceased no_zero')),
        'again': (remembering(drives_again), dict.fromkeys(EVERYWHERE, 'drove_on')),
        'once': (remembering(once), dict.fromkeys(EVERYWHERE, 'ceased one_command')),
        'zero': (lambda: lambda pose: (0.0, 0.0), dict.fromkeys(EVERYWHERE, 'all_zero')),
        'rarely': (remembering(rarely), {
            **dict.fromkeys(EVERYWHERE, 'late rare'), 'slow_base': 'unfinished rare'}),
        'creeps': (driving(way, 0.004), dict.fromkeys(EVERYWHERE, 'unfinished')),
        'turns': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw)), dict.fromkeys(EVERYWHERE, 'only_turned'))},
    'heading': {
        'right': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw)), {}),
        'not wrapped': (turning(lambda yaw: RIGHT_ANGLE - yaw), {'moved_start': 'long_way not_wrapped'}),
        'to 360': (turning(heading_to_360), {'slow_base': 'long_way not_wrapped'}),
        'sign': (turning(lambda yaw: wrap_to_pi(yaw - RIGHT_ANGLE)), dict.fromkeys(EVERYWHERE, 'rings sign')),
        'degrees': (turning(lambda yaw: 90 - yaw), dict.fromkeys(EVERYWHERE, 'long_way degrees')),
        'orientation.z': (turning(lambda yaw: RIGHT_ANGLE - math.sin(yaw / 2)),
                          dict.fromkeys(EVERYWHERE, 'long_way quaternion')),
        'asin': (turning(lambda yaw: RIGHT_ANGLE - math.asin(math.sin(yaw))), {'moved_start': 'long_way half_circle'}),
        'without sign': (turning(lambda yaw: abs(wrap_to_pi(RIGHT_ANGLE - yaw))),
                         {'moved_start': 'long_way half_circle'}),
        'half the angle': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw / 2)), dict.fromkeys(EVERYWHERE, 'elsewhere')),
        'gain of 9': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 9.0), {'odom_5hz': 'long_way gain_high'}),
        'wrong derivative': (remembering(wrong_derivative),
                             dict.fromkeys(('plain', 'moved_start', 'odom_5hz'), 'rings')),
        'by': (remembering(turn_by), dict.fromkeys(('moved_start', 'slow_base'), 'elsewhere turns_by')),
        'time': (remembering(turn_by_time), {'slow_base': 'elsewhere open_loop'}),
        'chatter': (turning(lambda yaw: math.copysign(1.0, wrap_to_pi(RIGHT_ANGLE - yaw))),
                    dict.fromkeys(EVERYWHERE, 'rings')),
        'high gain': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 10.0), {'odom_5hz': 'rings gain_high'}),
        'low gain': (turning(lambda yaw: wrap_to_pi(RIGHT_ANGLE - yaw), 0.01),
                     dict.fromkeys(EVERYWHERE, 'unfinished gain_low')),
        'equality': (lambda: lambda pose: (0.0, 0.5), dict.fromkeys(EVERYWHERE, 'long_way')),
        'drives': (driving(way), dict.fromkeys(EVERYWHERE, 'only_drove'))},
    'moved_distance': {
        'right': (counting(way), {}),
        'right, by speed': (counting(lambda last, pose: abs(pose.linear) * (pose.time - last.time)), {}),
        'right, once a second': (remembering(once_a_second), {}),
        'right, while it moves': (remembering(while_moving), {}),
        'kilometres': (counting(lambda last, pose: way(last, pose) / 1000),
                       dict.fromkeys(ON_THE_ROUTE, 'miscounted')),
        'never': (lambda: lambda pose: 0.0, dict.fromkeys(ON_THE_ROUTE, 'miscounted')),
        'displacement': (remembering(lambda memory, pose: way(memory['start'], pose)),
                         dict.fromkeys(ON_THE_ROUTE, 'displacement')),
        'displacement, by speed': (remembering(place_by_speed), dict.fromkeys(ON_THE_ROUTE, 'displacement')),
        'one axis': (counting(lambda last, pose: abs(pose.x - last.x)),
                     dict.fromkeys(ON_THE_ROUTE, 'miscounted one_axis')),
        'sum': (counting(lambda last, pose: pose.x - last.x + pose.y - last.y),
                dict.fromkeys(ON_THE_ROUTE, 'miscounted sum_of_axes')),
        'rounded': (counting(rounded), {'route': 'miscounted rounded', 'moved_start': 'miscounted rounded',
                                        'slow_base': 'miscounted rounded'}),
        'squares': (counting(lambda last, pose: way(last, pose)**2),
                    dict.fromkeys(ON_THE_ROUTE, 'miscounted squares')),
        'backwards': (counting(lambda last, pose: pose.linear * (pose.time - last.time)),
                      dict.fromkeys(ON_THE_ROUTE, 'miscounted backwards')),
        'fixed time': (counting(lambda last, pose: abs(pose.linear) * 0.05), {'odom_5hz': 'miscounted fixed_dt'}),
        'thousandths': (counting(lambda last, pose: abs(pose.linear) * 0.001),
                        dict.fromkeys(ON_THE_ROUTE, 'miscounted fixed_dt')),
        'twice': (counting(lambda last, pose: 2 * way(last, pose)), dict.fromkeys(ON_THE_ROUTE, 'miscounted times')),
        'from zero': (remembering(from_origin), {'moved_start': 'miscounted from_origin'}),
        'one step': (remembering(one_step), dict.fromkeys(ON_THE_ROUTE, 'miscounted last_step'))}}


@pytest.mark.parametrize('exercise, case', [(exercise, case) for exercise, cases in CASES.items() for case in cases])
def test_a_behaviour_gets_its_rule_and_no_hint_that_is_not_proven(exercise, case):
    node, expected = CASES[exercise][case]
    found = {scenario: f'{verdict.rule} {verdict.hint}'.strip()
             for scenario, verdict in verdicts(exercise, node).items() if not verdict.has_passed}
    assert found == expected


def test_a_fit_needs_a_second_rate():
    """At one rate alone many a mistake looks like another."""
    found = verdicts('moved_distance', counting(lambda last, pose: abs(pose.x - last.x)), ['route', 'moved_start'])
    assert [verdict.hint for verdict in found.values()] == ['', '']


def test_where_nothing_proves_a_cause_the_report_says_so():
    """And a place is that of the moment that the sentence speaks of."""
    found = verdicts('heading', turning(lambda yaw: 0.5, 1.0), ['plain'])
    assert found['plain'].sentence.endswith(
        'We do not know why: print the heading in your loop, and look at the picture')
    ceased = verdicts('two_meters', remembering(without_zero), ['plain'])['plain']
    assert 'came at 1.99 m' in ceased.sentence and 'at 2.11 m' in ceased.sentence
    spins = verdicts('two_meters', remembering(spins_at_the_goal), ['plain'])['plain']
    assert spins.sentence.endswith('after 6.7 s'), spins.sentence
    counted = verdicts('moved_distance', CASES['moved_distance']['thousandths'][0])['route']
    assert 'times a fixed 0.001 s' in counted.sentence, counted.sentence


@pytest.mark.parametrize('before, since, hint', [
    ('', f'Exception in thread Thread-6:\n{ERROR}', 'error'), (f'Exception in thread Thread-6:\n{ERROR}', '', ''),
    ('', 300 * BAD_CALLBACK, 'error'), ('', BAD_CALLBACK, ''), (100 * BAD_CALLBACK, 300 * BAD_CALLBACK, '')])
def test_an_error_is_the_cause_of_silence_on_the_way_if_it_begins_with_the_silence(before, since, hint):
    """What fails while the robot drives, or once, is a note."""
    exercise = EXERCISES['two_meters']
    run = drive(exercise.scenarios[0], remembering(silent_halfway), exercise.target)
    run.output, run.printed = before + since, len(before + since)
    run.commands = [command._replace(printed=len(before)) for command in run.commands]
    verdict, = verdicts_on([run], exercise)
    assert (verdict.rule, verdict.hint) == ('ceased', hint), verdict
    assert ('error' in verdict.notes) == (not hint)


@pytest.mark.parametrize('delay, speeds, expected', [
    (0.0, [0.0, 0.2], 'interrupt again'), (0.0, [0.2], 'interrupt on_shutdown'), (7.5, [0.2, 0.0], 'interrupt_late'),
    (7.5, [0.0], 'passed')])
def test_what_came_after_ctrl_c_tells_what_is_wrong(delay, speeds, expected):
    exercise = EXERCISES['two_meters']
    run = drive(exercise.scenarios[2], driving(way), exercise.target)
    run.commands[run.interrupted:] = [Command(run.now + delay, speed, 0.0, (), 'cmd_vel') for speed in speeds]
    verdict, = verdicts_on([run], exercise)
    assert f'{verdict.rule} {verdict.hint}'.strip() == expected, verdict.sentence


def test_an_exit_status_at_the_goal_is_a_note_and_the_drive_is_judged():
    exercise = EXERCISES['two_meters']
    run = drive(exercise.scenarios[0], remembering(without_zero), exercise.target)
    run.status, run.output = 1, 'Goal reached\n'
    verdict, = verdicts_on([run], exercise)
    assert (verdict.rule, verdict.hint) == ('ceased', 'no_zero'), verdict.sentence
    assert verdict.notes['exit_status'] == 'your node ended with status 1, and said last: Goal reached'


def test_a_command_before_time_begins_moves_no_robot():
    exercise = EXERCISES['two_meters']
    run = drive(exercise.scenarios[0], lambda: lambda pose: None, exercise.target)
    run.commands.append(Command(0.0, 0.2, 0.0, (), 'cmd_vel'))
    verdict, = verdicts_on([run], exercise)
    assert (verdict.rule, verdict.hint) == ('before_start', 'one_command'), verdict.sentence


def test_a_controller_that_never_settles_is_watched_for_some_sixty_changes_of_direction():
    run = drive(EXERCISES['heading'].scenarios[0],
                turning(lambda yaw: wrap_to_pi(yaw - RIGHT_ANGLE), 20.0), 90.0)
    assert run.now < 30.0, run.now
