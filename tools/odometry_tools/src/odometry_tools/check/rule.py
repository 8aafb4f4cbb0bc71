"""What a rule is."""

from typing import Callable, NamedTuple


class Rule(NamedTuple):
    """Something that may show in a run."""

    name: str
    test: Callable  # of the measures of a run
    sentence: str  # with measures in braces
    explains: bool = False  # whether the sentence says why, too

    def say(self, m):
        """Return the sentence with the numbers of a run."""
        return self.sentence.format(**vars(m))


def first(rules, m):
    """Return the first rule that holds, or None."""
    return next((rule for rule in rules if rule.test(m)), None)
