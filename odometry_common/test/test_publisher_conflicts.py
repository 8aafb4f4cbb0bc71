"""Several nodes that publish what only one should."""

import pytest
from odometry_common.publisher_conflicts import ConflictWatch, period_after


@pytest.mark.parametrize('looks, reported', [
    (['a', 'a', 'a'], {}),
    (['a', 'ab', 'ab', 'ab'], {2: 'ab'}),
    (['ab', 'a', 'ac', 'a'], {}),  # b and c were shutting down
    (['a', 'a', 'b', 'b'], {}),  # as after a restart
    (['ab', 'ab', 'abc', 'abc', 'abc'], {1: 'ab', 3: 'abc'}),
    (['ab', 'ab', 'a', 'a', 'ab', 'ab'], {1: 'ab'}),  # one that comes back is no news
    (['ab', 'ab', 'ac', 'ac'], {1: 'ab', 3: 'ac'})])
def test_each_conflict_that_lasts_is_reported_once(looks, reported):
    """A name is a letter here."""
    watch = ConflictWatch()
    said = {number: ''.join(watch.news(set(names))) for number, names in enumerate(looks)}
    assert {number: names for number, names in said.items() if names} == reported


@pytest.mark.parametrize('duration, period', [(0.001, 1.0), (0.01, 5.0), (10.0, 30.0)])
def test_a_slow_master_is_asked_less_often_but_is_asked(duration, period):
    """It may answer slowly once only, on a busy machine."""
    assert period_after(duration) == period
