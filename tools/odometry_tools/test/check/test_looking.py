"""A node is judged, and not its luck: what a right node may fail by chance is looked at again."""

import pytest
from kinematic_robot import drive
from odometry_tools.check.bench import Pace
from odometry_tools.check.judging import verdicts_on
from odometry_tools.check.looking import LOOKS, look
from odometry_tools.check.scenarios import EXERCISES

EXERCISE = EXERCISES['two_meters']
PLAIN = EXERCISE.scenarios[0]


class Runner:
    """Has Runs to give."""

    def __init__(self, *runs):
        """Give these, one after the other."""
        self._runs = [*runs]
        self.exercise, self.follows_wall = EXERCISE, None

    def run(self, _scenario):
        """Return the next."""
        return self._runs.pop(0)

    run_again = run


def run_of(distance, has_zero=True, **facts):
    """Return the Run of a node that drives so far (m), and perhaps stops."""
    def answer(pose):
        return (0.5, 0.0) if pose.x < distance else (0.0, 0.0) if has_zero else None
    run = drive(PLAIN, lambda: answer, None)
    vars(run).update(facts)
    return run


def verdict_on(runner):
    """Return the Verdict on what a Runner gives."""
    return verdicts_on([look(runner, PLAIN)], EXERCISE)[0]


def test_a_zero_that_was_lost_once_fails_nobody():
    """And a note says so."""
    verdict = verdict_on(Runner(run_of(2.0, has_zero=False, status=0), run_of(2.0)))
    assert verdict.has_passed
    assert 'only when it was looked at again' in verdict.notes['luck']


def test_a_zero_that_is_never_there_fails():
    runner = Runner(*(run_of(2.0, has_zero=False, status=0) for _ in range(LOOKS)))
    assert verdict_on(runner).rule == 'ceased'


def test_a_node_that_lockstep_does_not_wait_for_is_looked_at_again():
    paced = {'unawaited': 'acts by wall time', 'pace': Pace(False, 5.0)}
    verdict = verdict_on(Runner(run_of(2.5, **paced), run_of(2.0, **paced)))
    assert verdict.has_passed
    assert [*verdict.notes] == ['wall_time']


@pytest.mark.parametrize('distances, rule', [((1.0, 1.01), 'early'), ((1.0, 1.6), 'wall_clock')])
def test_two_runs_that_differ_are_no_measure(distances, rule):
    """A tick more or less is the turn of a thread."""
    assert verdict_on(Runner(*map(run_of, distances))).rule == rule
