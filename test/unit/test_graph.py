"""What a demo waits for while it starts, without a master."""

import pytest
from odometry_launch.graph import DemoError, Graph


class Nodes(Graph):
    """A context that is never entered, whose nodes go on."""

    def __init__(self):
        """Begin without any."""

    def check(self):
        """Find none that has ended."""


def test_a_wait_ends_once_its_condition_holds():
    """Nobody answers at first."""
    answers = iter([OSError('no connection'), False, True])

    def condition():
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    Nodes().wait_for(condition, 'no answer')
    assert not list(answers)


@pytest.mark.parametrize('error', [AttributeError('no such thing'), SystemExit('no such thing')])
def test_an_unexpected_error_ends_a_wait_at_once(error):
    """With a line that names it, instead of three minutes in which nothing happens."""
    def condition():
        raise error

    with pytest.raises(DemoError) as failure:
        Nodes().wait_for(condition, 'the nodes do not answer')
    assert str(failure.value) == f'the nodes do not answer: {type(error).__name__}: no such thing'
