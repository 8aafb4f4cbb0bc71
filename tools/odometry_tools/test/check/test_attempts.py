"""A node is judged, and not its luck: a run that a right node may fail by chance is repeated."""

from types import SimpleNamespace

import pytest
from kinematic_robot import PLAIN, TWO_METERS, drive, verdict_on
from odometry_tools.check.attempts import ATTEMPTS, run_until_sure
from odometry_tools.check.check_session import Pace

PACED = {'unawaited': 'acts by wall time', 'pace': Pace(False, 5.0)}


def run_of(distance, has_zero=True, **facts):
    """Return the Run of a node that drives so far (m), and perhaps stops."""
    def answer(pose):
        return (0.5, 0.0) if pose.x < distance else (0.0, 0.0) if has_zero else None
    run = drive(lambda: answer)
    vars(run).update(facts)
    return run


def attempt(*runs):
    """Return the Verdict on the last of scenarios that give these Runs, one at each attempt."""
    given = [*runs]
    runner = SimpleNamespace(exercise=TWO_METERS, follows_wall=None, confirmed=set())
    runner.run = runner.run_again = lambda *_: given.pop(0)
    while given:
        run = run_until_sure(runner, PLAIN)
    return verdict_on(run)


def test_a_zero_that_was_lost_once_fails_nobody():
    """And a note says so."""
    verdict = attempt(run_of(2.0, has_zero=False, status=0), run_of(2.0))
    assert verdict.has_passed
    assert 'only when it was run again' in verdict.notes['luck']


def test_a_node_that_lockstep_does_not_wait_for_runs_again():
    verdict = attempt(run_of(2.5, **PACED), run_of(2.0, **PACED))
    assert verdict.has_passed
    assert [*verdict.notes] == ['wall_time']


def test_one_run_that_ends_at_ctrl_c_shows_that_the_node_ends():
    runs = [run_of(9.0, interrupted=3, ends=ends) for ends in (True, False, False)]
    assert attempt(*runs).rule == 'interrupt'


def test_a_failure_at_each_pace_is_not_repeated_in_the_next_scenario():
    assert attempt(*(ATTEMPTS + 1) * [run_of(1.0, **PACED)]).rule == 'early'


@pytest.mark.parametrize('distances, rule', [((1.0, 1.01), 'early'), ((9.0, 9.0, 1.0, 1.6), 'wall_clock')])
def test_two_runs_that_differ_are_no_measure(distances, rule):
    """A tick more or less is the turn of a thread; two that the check has to end say nothing."""
    assert attempt(*map(run_of, distances)).rule == rule
