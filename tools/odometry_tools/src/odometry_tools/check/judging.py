"""Judge runs: the first rule that holds is the verdict; a hint follows where one is proven."""

from typing import NamedTuple

import numpy

from odometry_tools.check import rules
from odometry_tools.check.hints import hint_for
from odometry_tools.check.measures import measure
from odometry_tools.check.rule import Rule, first
from odometry_tools.runs.plain_text import plain

PASSED = Rule('passed', None, '')
# The word beside the scenario, by rule; for other rules FAILED.
WORDS = {'passed': 'passed', 'displacement': 'DIFFERS'}
RULES = {'moved_distance': rules.DETECTOR, 'two_meters': (*rules.DRIVE, *rules.DISTANCE),
         'heading': (*rules.DRIVE, *rules.HEADING)}
SAME_HEADING = 1.0  # degrees
SAME_TURN = 0.05  # share of a turn by which another one may be larger


class Verdict(NamedTuple):
    """The verdict on one scenario."""

    scenario: str
    rule: str  # 'passed' or the name of the rule that holds
    hint: str  # the name of the hint, or ''
    sentence: str
    notes: dict  # sentences by the names of their rules

    @property
    def word(self):
        """The word beside the scenario."""
        return WORDS.get(self.rule, 'FAILED')

    @property
    def has_passed(self):
        """Whether the node passed."""
        return self.rule == PASSED.name


def judge(run, exercise):
    """Return the measures of a Run of an Exercise, and the first Rule that holds."""
    m = measure(run, exercise)
    held = PASSED if m.passed else first((*rules.START, *RULES[exercise.name]), m)
    m.rule = held.name
    return m, held


def verdicts_on(runs, exercise):
    """Return the Verdicts on all Runs of an Exercise; hints compare the runs."""
    judged = [judge(run, exercise) for run in runs]
    _compare([m for m, _ in judged])
    return [_verdict_on(m, held) for m, held in judged]


def _compare(all_measures):
    """Add to the measures of each scenario what a comparison of all shows."""
    fits = [m.fits for m in all_measures if m.exercise.route and m.fits is not None]
    has_slow_odometry = any(m.rate < 20 for m in all_measures)
    common_fits = set.intersection(*fits) if fits and has_slow_odometry else set()
    whole = [m for m in all_measures if m.run.interrupted is None]
    # A timed turn is shorter on a slow base.
    nets = [m.net for m in whole
            if m.net is not None and m.rate >= 20 and m.scenario.speed_ratio == 1]
    reference = all_measures[0]
    shared = {
        'plain': reference if len(all_measures) > 1 else None,
        'rules_at_start': {m.rule for m in whole if m.scenario.start == reference.scenario.start},
        'same_heading': _has_same_heading(whole),
        'common_fits': common_fits,
        'factor': next((factor for _, factor in common_fits), None)}
    for m in all_measures:
        vars(m).update(shared)
        m.turns_by = len(nets) > 1 and m.net is not None and (
            numpy.ptp([*nets, m.net]) < SAME_TURN * min(map(abs, nets)))
        m.fails_alone = len(whole) > 1 and not any(
            one.passed == (one is m) for one in whole)


def _has_same_heading(all_measures):
    """Return whether the robot rests at one wrong heading from different starts."""
    resting = [m for m in all_measures if m.rule == 'elsewhere']
    starts = {m.scenario.start for m in resting}
    headings = [m.heading for m in resting]
    return len(starts) > 1 and numpy.ptp(headings) < SAME_HEADING


def _verdict_on(m, held):
    hint = None if m.passed or held.explains else hint_for(m)
    m.hint = hint.name if hint else ''
    notes = {rule.name: plain(rule.say(m)) for rule in rules.NOTES if rule.test(m)}
    if m.passed:
        kind = ('interrupt' if m.run.interrupted is not None
                else 'paced' if m.run.unawaited else m.exercise.name)
        sentence = rules.PRAISE[kind].format(**vars(m))
    else:
        sentence = '. '.join(rule.say(m) for rule in (held, hint) if rule)
    return Verdict(m.scenario.name, held.name, m.hint, plain(sentence), notes)
