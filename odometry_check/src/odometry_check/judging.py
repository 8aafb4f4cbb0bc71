"""The verdict on a Run: the first rule that holds, and its sentence with the numbers."""

from typing import NamedTuple

from odometry_check import rules
from odometry_check.measures import measure

RULES = {'moved_distance': (*rules.START, *rules.DETECTOR),
         'two_meters': (*rules.START, *rules.DRIVE, *rules.DISTANCE),
         'heading': (*rules.START, *rules.DRIVE, *rules.HEADING)}
PRAISE = {'moved_distance': 'counted {total:.2f} of {right:.2f} m',
          'two_meters': 'at {gone:.2f} m after {driven:.1f} s',
          'heading': 'at {yaw:.2f} degrees after {arrival:.1f} s'}
STOPPED = 'stopped the robot after Ctrl-C'
PASSED = 'passed'


class Verdict(NamedTuple):
    """On one scenario."""

    scenario: str
    rule: str  # PASSED or the name of the rule that holds
    sentence: str
    notes: dict  # sentences by the names of their rules

    @property
    def word(self):
        """What stands beside the scenario."""
        return self.rule if self.rule in (PASSED, 'displacement') else 'FAILED'


def judge(run, name, exercise):
    """Return the Verdict on a Run of an Exercise, which has a name."""
    m = measure(run, exercise)
    notes = {rule.name: rule.sentence.format(**vars(m))
             for rule in (*rules.NOTES, *(rules.DRIVE_NOTES if run.odometry and not exercise.route else ())) if rule.holds(m)}
    if m.passed:
        praise = PRAISE[name] if run.interrupted is None else STOPPED
        return Verdict(run.scenario.name, PASSED, praise.format(**vars(m)), notes)
    rule = next(rule for rule in RULES[name] if rule.holds(m))
    return Verdict(run.scenario.name, rule.name, rule.sentence.format(**vars(m)), notes)
