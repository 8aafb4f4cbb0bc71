"""The controllers' clocks: what is due, and what is at rest; test_control_loop has the watchdog."""

import pytest
from odometry_common.timing import Metronome, RestDetector

BAND, DURATION = 0.001, 0.5


def beats(metronome, stamps):
    """Return the times at which a period began."""
    return [now for now in stamps if metronome.is_due(now)]


@pytest.mark.parametrize('start', [0.0, 1.7e9])
@pytest.mark.parametrize('rate', [10, 20, 25, 1000])
def test_any_faster_input_keeps_the_average_of_ten_beats_a_second(rate, start):
    """The beat falls on messages; 25 Hz is no multiple, yet no beat is lost, nor doubled."""
    found = beats(Metronome(0.1), [start + number / rate for number in range(60 * rate)])
    assert 600 <= len(found) <= 601
    gaps = [later - sooner for sooner, later in zip(found, found[1:])]
    assert 0.099 - 1 / rate - 1e-6 <= min(gaps) and max(gaps) <= 0.1 + 1 / rate + 1e-6


@pytest.mark.parametrize('rounding', [-1e-6, 1e-6])
def test_rounded_time_stamps_lose_no_beat(rounding):
    """A stamp that is a microsecond early is meant for the beat."""
    stamps = [number * 0.1 + rounding * (number % 2) for number in range(100)]
    assert beats(Metronome(0.1), stamps) == stamps


@pytest.mark.parametrize('stamps, expected', [
    ([100.0, 100.05, 0.03, 0.08, 0.13, 0.18, 0.23], [100.0, 0.03, 0.13, 0.23]),  # back
    ([0.0, 5.03, 5.05, 5.07, 5.09, 5.11, 5.13], [0.0, 5.03, 5.13])])  # a gap
def test_time_that_leaps_begins_a_new_row(stamps, expected):
    """A reset silences no controller, and no missed beat is made up for."""
    assert beats(Metronome(0.1), stamps) == expected


@pytest.mark.parametrize('rows, rests', [
    ([(0, 0), (0.25, BAND), (0.5, -BAND), (0.75, 0)], [2, 3]),  # within the band
    ([(0, 0), (0.4, 0.1), (0.5, 0.1), (0.8, 0.1), (0.9, 0.1)], [4]),  # from the last motion on
    ([(number * 0.05, number * 2e-4) for number in range(200)], []),  # slow motion is no rest
    ([(1000, 0), (5, 0), (5.4, 0), (5.5, 0)], [3])])  # time goes back
def test_a_value_is_at_rest_once_it_has_stayed_for_the_duration(rows, rests):
    """Rows of time and value; the numbers of those at which it is at rest."""
    detector = RestDetector(BAND, DURATION)
    assert [number for number, row in enumerate(rows) if detector.at_rest(*row)] == rests


def test_a_reset_forgets_the_rest():
    detector = RestDetector(BAND, DURATION)
    detector.at_rest(0.0, 0.0)
    detector.reset()
    assert not detector.at_rest(0.6, 0.0)
    assert detector.at_rest(1.1, 0.0)
