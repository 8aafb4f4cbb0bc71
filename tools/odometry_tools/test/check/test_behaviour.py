"""What the check says of a robot's behaviour, without ROS: each node is a function of the odometry."""

import math

import pytest
from behaviours import (
    RIGHT_ANGLE,
    adds_displacements,
    by_time,
    counting,
    drives_again,
    driving,
    error_of,
    from_origin,
    narrow_window,
    once,
    one_step,
    overshooting,
    place_by_speed,
    rarely,
    rounded,
    spins_at_the_goal,
    turn_by,
    turning,
    way,
    while_moving,
    without_zero,
    wrong_derivative,
)
from kinematic_robot import TWO_METERS, drive, verdict_on, verdicts
from learners import BAD_CALLBACK
from odometry_tools.check.endings import Drive
from odometry_tools.check.run import Command
from odometry_tools.check.scenarios import EXERCISES

# The node, and the rule and hint of the scenarios that are not passed, or of all.
CASES = {
    'two_meters': {
        'right': (driving(way), {}),
        'right, overshoots': (overshooting, {}),
        'position': (driving(lambda start, pose: pose.x), {'moved_start': 'all_zero start'}),
        'one axis': (driving(lambda start, pose: abs(pose.x - start.x)), {'moved_start': 'late one_axis'}),
        'sum': (driving(lambda start, pose: abs(pose.x - start.x) + abs(pose.y - start.y)),
                {'moved_start': 'early sum_of_axes'}),
        'a point': (driving(lambda start, pose: 2.03 - math.hypot(2.0 - pose.x, pose.y)), {'moved_start': 'early place'}),
        'root': (driving(lambda start, pose: way(start, pose)**2), 'early'),
        'window': (narrow_window, {'odom_5hz': 'passed_by slow_odometry'}),
        'time': (by_time, {'slow_base': 'early open_loop'}),
        'again': (drives_again, 'drove_on'),
        'once': (once, 'ceased one_command'),
        'four times': (lambda: lambda pose: (0.2, 0.0) if pose.time < 0.5 else None, 'ceased'),
        'rarely': (rarely, 'late'),
        'turns': (turning(error_of), 'only_turned')},
    'heading': {
        'right': (turning(error_of), {}),
        'not wrapped': (turning(lambda yaw: RIGHT_ANGLE - yaw), {'moved_start': 'long_way longer_way'}),
        'to 360': (turning(lambda yaw: RIGHT_ANGLE - yaw % math.tau), {'slow_base': 'long_way longer_way'}),
        'sign': (turning(lambda yaw: -error_of(yaw)), 'rings sign'),
        'degrees': (turning(lambda yaw: 90 - yaw), 'long_way degrees'),
        'orientation.z': (turning(lambda yaw: RIGHT_ANGLE - math.sin(yaw / 2)), 'long_way quaternion'),
        'asin': (turning(lambda yaw: RIGHT_ANGLE - math.asin(math.sin(yaw))), {'moved_start': 'long_way half_circle'}),
        'degrees wrapped by pi': (turning(lambda yaw: math.remainder(error_of(yaw), 0.1)), 'elsewhere'),
        'wrong derivative': (wrong_derivative, dict.fromkeys(('plain', 'moved_start', 'odom_5hz'), 'rings')),
        'by': (turn_by, dict.fromkeys(('moved_start', 'slow_base'), 'elsewhere turns_by')),
        'for three seconds': (lambda: lambda pose: (0.0, 0.5) if pose.time < 3.1 else None, {
            'plain': 'ceased no_zero', 'odom_5hz': 'ceased no_zero', 'moved_start': 'ceased turns_by',
            'slow_base': 'ceased open_loop'}),
        'high gain': (turning(error_of, 10.0), {'odom_5hz': 'rings gain_high'}),
        'low gain': (turning(error_of, 0.01), 'unfinished gain_low'),
        'square': (lambda: lambda pose: (0.2, 0.0) if pose.time % 13 < 10 else (0.0, 0.5), 'unfinished'),
        'drives': (driving(way), 'only_drove')},
    'moved_distance': {
        'right': (counting(way), {}),
        'right, by speed': (counting(lambda last, pose: abs(pose.linear) * (pose.time - last.time)), {}),
        'right, while it moves': (while_moving, {}),
        'displacement, by speed': (place_by_speed, 'displacement'),
        'one axis': (counting(lambda last, pose: abs(pose.x - last.x)), 'miscounted one_axis'),
        'sum': (counting(lambda last, pose: pose.x - last.x + pose.y - last.y), 'miscounted sum_of_axes'),
        'rounded': (counting(rounded), {'route': 'miscounted rounded', 'moved_start': 'miscounted rounded', 'slow_base': 'miscounted rounded'}),
        'squares': (counting(lambda last, pose: way(last, pose)**2), 'miscounted squares'),
        'backwards': (counting(lambda last, pose: pose.linear * (pose.time - last.time)), 'miscounted backwards'),
        'fixed time': (counting(lambda last, pose: abs(pose.linear) * 0.05), {'odom_5hz': 'miscounted fixed_dt'}),
        'twice': (counting(lambda last, pose: 2 * way(last, pose)), 'miscounted times'),
        'from zero': (from_origin, {'moved_start': 'miscounted from_origin'}),
        'displacements': (adds_displacements, 'miscounted displacements'),
        'half of one, by time': (counting(lambda last, pose: way(last, pose) * (pose.time - last.time) * 10), 'miscounted'),
        'one step': (one_step, 'miscounted last_step')}}


@pytest.mark.parametrize('exercise, case', [(exercise, case) for exercise, cases in CASES.items() for case in cases])
def test_a_behaviour_gets_its_rule_and_no_hint_that_is_not_proven(exercise, case):
    node, expected = CASES[exercise][case]
    if isinstance(expected, str):
        expected = {scenario.name: expected for scenario in EXERCISES[exercise].scenarios if not scenario.interrupt}
    found = {scenario: f'{verdict.rule} {verdict.hint}'.strip()
             for scenario, verdict in verdicts(EXERCISES[exercise], node).items() if not verdict.has_passed}
    assert found == expected


def test_a_fit_needs_a_second_rate():
    """At one rate alone many a mistake looks like another."""
    detector = EXERCISES['moved_distance']
    found = verdicts(detector._replace(scenarios=detector.scenarios[:2]), CASES['moved_distance']['one axis'][0])
    assert [verdict.hint for verdict in found.values()] == ['', '']


@pytest.mark.parametrize('exercise, node, words', [
    ('two_meters', without_zero, "came at 1.99 m, and only the base's watchdog stopped the robot, at 2.11 m"),
    ('two_meters', spins_at_the_goal, 'after 6.7 s'),
    ('heading', CASES['heading']['degrees'][0], 'degrees when this was ended, still with')])
def test_a_sentence_says_what_was_seen(exercise, node, words):
    """A place is that of the moment of which it speaks."""
    verdict, *_ = verdicts(EXERCISES[exercise], node).values()
    assert words in verdict.sentence


@pytest.mark.parametrize('output, words', [
    (300 * BAD_CALLBACK, 'Your callback fails again and again: NameError: no x, line 7'),
    (BAD_CALLBACK, 'We do not know why, but your node printed an error: NameError')])
def test_a_callback_that_failed_once_is_no_cause(output, words):
    run = drive(CASES['two_meters']['four times'][0])
    run.output = output
    verdict = verdict_on(run)
    assert words in verdict.sentence
    assert not verdict.notes


@pytest.mark.parametrize('delay, speeds, expected', [
    (0.0, [0.0, 0.2], 'interrupt_again'), (7.5, [0.2, 0.0], 'interrupt_late'),
    (7.5, [0.0], 'passed')])
def test_what_came_after_ctrl_c_tells_what_is_wrong(delay, speeds, expected):
    run = drive(driving(way), TWO_METERS.scenarios[2])
    run.commands[run.interrupted:] = [Command(run.now + delay, speed, 0.0, (), 'cmd_vel') for speed in speeds]
    verdict = verdict_on(run)
    assert f'{verdict.rule} {verdict.hint}'.strip() == expected, verdict.sentence


def test_an_exit_status_at_the_goal_is_a_note_and_the_drive_is_judged():
    run = drive(without_zero)
    run.status, run.output = 1, 'Goal reached\n'
    verdict = verdict_on(run)
    assert (verdict.rule, verdict.hint) == ('ceased', 'no_zero'), verdict.sentence
    assert verdict.notes['exit_status'] == 'your node ended with status 1, and said last: Goal reached'


def test_commands_that_come_too_rarely_are_a_note():
    assert verdict_on(drive(rarely)).notes == {
        'rare': 'your commands come every 10.0 s, and the base stops 0.6 s after each'}


@pytest.mark.parametrize('node', [once, lambda: lambda pose: None])
def test_a_run_goes_on_while_its_node_may_sleep_by_wall_time(node):
    run = drive(node)
    run.begin = run.latest = math.inf  # s of wall time
    assert not Drive().is_over(run)
    run.status = 0
    assert Drive().is_over(run)


def test_a_command_before_time_begins_moves_no_robot():
    run = drive(lambda: lambda pose: None)
    run.commands.append(Command(0.0, 0.2, 0.0, (), 'cmd_vel'))
    verdict = verdict_on(run)
    assert (verdict.rule, verdict.hint) == ('before_start', 'one_command'), verdict.sentence
