"""Other nodes that command the same robot."""

import pytest
from odometry_common.rivals import RivalWatch, period_after


@pytest.mark.parametrize('looks, told', [
    (['', '', ''], {}),
    (['', 'a', 'a', 'a', 'a'], {2: 'a'}),
    (['a', '', 'a', '', 'b', ''], {}),  # each is about to end
    (['a', 'a', 'ab', 'ab', 'ab'], {1: 'a', 3: 'ab'}),
    (['ab', 'ab', 'a', 'a', 'ab', 'ab'], {1: 'ab'}),  # who comes back is no news
    (['ab', 'ab', 'c', 'c'], {1: 'ab', 3: 'c'}),
])
def test_each_rival_that_stays_is_told_of_once(looks, told):
    """With those that are known already; a name is a letter here."""
    watch = RivalWatch()
    said = {number: ''.join(watch.news(set(names))) for number, names in enumerate(looks)}
    assert {number: names for number, names in said.items() if names} == told


@pytest.mark.parametrize('duration, period', [(0.001, 1.0), (0.01, 5.0), (10.0, 30.0)])
def test_a_slow_master_is_asked_less_often_but_is_asked(duration, period):
    """It may answer slowly once only, on a busy machine."""
    assert period_after(duration) == period
