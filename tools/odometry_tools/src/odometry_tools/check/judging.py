"""The verdict on a Run: the first rule that holds, and its sentence with the numbers."""

from pathlib import Path
from typing import NamedTuple

import rospkg
import yaml

from odometry_tools.check import rules
from odometry_tools.check.measures import measure

PASSED = 'passed'
WORDS = {PASSED: PASSED, 'displacement': 'DIFFERS'}  # what stands beside the scenario; of others FAILED
GROUPS = {'moved_distance': ('start', 'detector'), 'two_meters': ('start', 'drive', 'distance'),
          'heading': ('start', 'drive', 'heading')}


class Verdict(NamedTuple):
    """On one scenario."""

    scenario: str
    rule: str  # PASSED or the name of the rule that holds
    sentence: str
    notes: dict  # sentences by the names of their rules

    @property
    def word(self):
        """What stands beside the scenario."""
        return WORDS.get(self.rule, 'FAILED')


class Judge:
    """Knows the sentences."""

    def __init__(self, name, exercise):
        """Judge an Exercise, which has a name."""
        self._name, self._exercise = name, exercise
        self._seen = set()  # rules that held in earlier scenarios
        path = Path(rospkg.RosPack().get_path('odometry_tools'), 'sentences.yaml')
        self._sentences = yaml.safe_load(path.read_text(encoding='utf-8'))

    def judge(self, run):
        """Return the Verdict on a Run."""
        m = measure(run, self._exercise)
        m.seen = self._seen
        is_drive = run.odometry and not self._exercise.route
        notes = dict(self._held(m, 'notes', *(['drive_notes'] if is_drive else [])))
        if m.passed:
            praise = self._sentences['praise'][self._name if run.interrupted is None else 'interrupt']
            return Verdict(m.name, PASSED, praise.format(**vars(m)), notes)
        rule, sentence = next(self._held(m, *GROUPS[self._name]))
        self._seen.add(rule)
        return Verdict(m.name, rule, sentence, notes)

    def _held(self, m, *groups):
        """Yield names and sentences of the rules that hold."""
        for group in groups:
            for name, holds in getattr(rules, group.upper()).items():
                if holds(m):
                    yield name, self._sentences[group][name].format(**vars(m))
