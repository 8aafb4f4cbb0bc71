"""The controllers' clocks: what is due, what is late, what is at rest."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_common.timing import Metronome, RestDetector, Watchdog

times = st.floats(0, 1e9)


def beats(metronome, stamps):
    """Return the times at which a period began."""
    return [now for now in stamps if metronome.is_due(now)]


@pytest.mark.parametrize('start', [0.0, 1.7e9])
@pytest.mark.parametrize('rate', [10, 20, 25, 30, 50, 1000, 5000])
def test_any_faster_input_keeps_the_average_of_ten_beats_a_second(rate, start):
    """The beat falls on messages; 25 Hz is no multiple, yet no beat is lost, nor doubled."""
    stamps = [start + number / rate for number in range(60 * rate)]
    found = beats(Metronome(0.1), stamps)
    assert 600 <= len(found) <= 601
    gaps = [later - sooner for sooner, later in zip(found, found[1:])]
    assert 0.099 - 1 / rate - 1e-6 <= min(gaps) and max(gaps) <= 0.1 + 1 / rate + 1e-6


def test_a_slower_input_beats_with_every_message():
    """A metronome adds no messages, and skips none."""
    stamps = [number / 4 for number in range(40)]
    assert beats(Metronome(0.1), stamps) == stamps


@pytest.mark.parametrize('rounding', [-1e-6, 1e-6])
def test_rounded_time_stamps_lose_no_beat(rounding):
    """A stamp that is a microsecond early is meant for the beat."""
    metronome = Metronome(0.1)
    stamps = [number * 0.1 + rounding * (number % 2) for number in range(100)]
    assert beats(metronome, stamps) == stamps


def test_time_that_goes_back_begins_a_new_row():
    """The reset of a simulator silences no controller."""
    metronome = Metronome(0.1)
    stamps = [100.0, 100.05, 0.03, 0.08, 0.13, 0.18, 0.23]
    assert beats(metronome, stamps) == [100.0, 0.03, 0.13, 0.23]


def test_after_a_gap_no_missed_beat_is_made_up_for():
    """Commands that come late all at once would be of no use."""
    metronome = Metronome(0.1)
    stamps = [0.0, 5.03, 5.05, 5.07, 5.09, 5.11, 5.13]
    assert beats(metronome, stamps) == [0.0, 5.03, 5.13]


@given(st.lists(times, min_size=1), st.floats(1e-3, 10))
def test_after_any_sequence_of_times_a_beat_follows_within_a_period(sequence, period):
    """Nothing that the clock does stops the metronome."""
    metronome = Metronome(period)
    beats(metronome, sequence)
    last = sequence[-1]
    assert beats(metronome, [last + period / 2, last + period, last + 1.5 * period])


@given(times, st.floats(1e-3, 100), st.floats(0, 200))
def test_a_watchdog_expires_when_the_silence_is_longer_than_its_timeout(now, timeout, silence):
    """And not at exactly the timeout."""
    watchdog = Watchdog(timeout)
    watchdog.feed(now)
    assert watchdog.expired(now + silence) == (now + silence - now > timeout)


def rest(detector, rows):
    """Return what the detector says after each (time, value)."""
    return [detector.at_rest(now, value) for now, value in rows]


def test_a_value_is_at_rest_once_it_has_stayed_for_the_duration():
    """Within its band, and at exactly the duration already."""
    detector = RestDetector(band=0.001, duration=0.5)
    rows = [(0.0, 0.0), (0.25, 0.001), (0.5, -0.001), (0.75, 0.0)]
    assert rest(detector, rows) == [False, False, True, True]


def test_slow_motion_is_no_rest():
    """Each step is small, but the value leaves the band before the duration ends."""
    detector = RestDetector(band=0.001, duration=0.5)
    assert not any(rest(detector, [(number * 0.05, number * 2e-4) for number in range(200)]))


def test_motion_begins_the_wait_anew():
    """Rest is counted from the last change."""
    detector = RestDetector(band=0.001, duration=0.5)
    rows = [(0.0, 0.0), (0.4, 0.1), (0.5, 0.1), (0.8, 0.1), (0.9, 0.1)]
    assert rest(detector, rows) == [False, False, False, False, True]


def test_a_reset_forgets_the_rest():
    """As when the robot is sent off again."""
    detector = RestDetector(band=0.001, duration=0.5)
    assert rest(detector, [(0.0, 0.0), (0.5, 0.0)]) == [False, True]
    detector.reset()
    assert rest(detector, [(0.6, 0.0), (1.0, 0.0), (1.1, 0.0)]) == [False, False, True]


def test_rest_is_counted_anew_when_time_goes_back():
    """A simulator that was reset ends no turn too early, and delays none."""
    detector = RestDetector(band=0.001, duration=0.5)
    rows = [(1000.0, 0.0), (5.0, 0.0), (5.4, 0.0), (5.5, 0.0)]
    assert rest(detector, rows) == [False, False, False, True]
