"""What is silent, and what is at rest."""

from types import SimpleNamespace

import pytest
from odometry_common.rest import RestDetector
from odometry_common.watchdog import Watchdog

BAND = 0.001
START, HOUR = 100.0, 3600.0  # s


@pytest.mark.parametrize('timeout, steps, silent', [
    (1.0, [(0.9, 0.9), (1.01, 1.01)], [False, True]),
    (0.0, [(HOUR, HOUR)], [False]),
    (1.0, [(0.9, HOUR)], [False]),  # a simulation that crawls
    (1.0, [(HOUR, 0.0), (HOUR, 0.19), (HOUR, 0.21)], [False, False, True]),  # a clock that leaps
    (0.1, [(0.11, 0.09), (0.11, 0.11)], [False, True]),
    (1.0, [(2.0, 0.1), (0.3, 0.15), (2.0, 0.19), (0.3, 0.3), (2.0, 0.9), (2.1, 1.01)],
     [False, False, False, False, False, True]),  # two clocks
    (1.0, [(-90.0, 0.5), (-89.1, 1.4), (-88.9, 1.6)], [False, False, True])])  # time goes back
def test_silence_lasts_for_the_timeout_and_a_while_of_wall_time(monkeypatch, timeout, steps, silent):
    """Steps are times since the last arrival: simulated and real (s)."""
    wall = SimpleNamespace(now=START, monotonic=lambda: wall.now)
    monkeypatch.setattr('odometry_common.watchdog.time', wall)
    watchdog = Watchdog(timeout)
    assert not watchdog.expired(START)
    watchdog.feed(START)
    found = []
    for simulated, real in steps:
        wall.now = START + real
        found.append(watchdog.expired(START + simulated))
    assert found == silent
    watchdog.feed(START + simulated)
    assert not watchdog.expired(START + simulated)


@pytest.mark.parametrize('rows, rests', [
    ([(0, 0), (0.25, BAND), (0.5, -BAND), (0.75, 0)], [2, 3]),  # within the band
    ([(0, 0), (0.4, 0.1), (0.8, 0.1), (0.9, 0.1)], [3]),  # from the last motion on
    ([(number * 0.05, number * 2e-4) for number in range(200)], []),  # slow motion is no rest
    ([(1000, 0), (5, 0), (5.4, 0), (5.5, 0)], [3])])  # time goes back
def test_a_value_is_at_rest_once_it_has_stayed_for_the_duration(rows, rests):
    """Rows of time and value; the numbers of those at which it is at rest."""
    detector = RestDetector(BAND)
    assert [number for number, row in enumerate(rows) if detector.at_rest(*row)] == rests
