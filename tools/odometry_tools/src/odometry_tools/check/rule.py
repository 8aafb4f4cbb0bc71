"""A rule: a condition on the measures of a run, and the sentence that reports it."""

from typing import Callable, NamedTuple


class Rule(NamedTuple):
    """A condition on the measures of a run, and the sentence that reports it."""

    name: str
    test: Callable  # takes the measures of a run
    sentence: str  # a format string of measures
    explains: bool = False  # whether the sentence names the cause, so that no hint follows

    def say(self, m):
        """Return the sentence with the numbers of a run."""
        return self.sentence.format(**vars(m))


def first(rules, m):
    """Return the first rule that holds, or None."""
    return next((rule for rule in rules if rule.test(m)), None)
