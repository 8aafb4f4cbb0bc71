"""Two nodes that publish what only one should."""

import pytest
from odometry_common.senders import SenderWatch


def notices(senders):
    """Return what is said about a row of messages, by number."""
    watch = SenderWatch()
    said = {number: watch.rivals(sender) for number, sender in enumerate(senders)}
    return {number: rivals for number, rivals in said.items() if rivals}


@pytest.mark.parametrize('senders', ['', 'a', 'aaaa', 'aaabbb', 'abcd'])
def test_one_sender_after_the_other_is_no_rivalry(senders):
    """A detector that is started anew has another name."""
    assert notices(senders) == {}


@pytest.mark.parametrize('senders, number', [
    ('ababab', 2), ('aaaabbbbaaaabbbb', 8), ('aba' + 'b' * 100 + 'ab', 2)])
def test_two_in_turn_are_noticed_once(senders, number):
    """When the first one is heard again."""
    assert notices(senders) == {number: ('a', 'b')}
