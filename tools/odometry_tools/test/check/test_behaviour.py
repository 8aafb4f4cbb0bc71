"""What the check says of a robot's behaviour, without ROS: each node is a function of the odometry."""

import pytest
from behaviours import CASES, RIGHT_ANGLE, counting, remembering, turning, without_zero
from kinematic_robot import drive, verdicts
from odometry_common.angles import wrap_to_pi
from odometry_tools.check.judging import verdicts_on
from odometry_tools.check.run import Command
from odometry_tools.check.scenarios import EXERCISES


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
