"""Simulated time: every message falls on a physics step, and no rounding adds up."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sim_turtlebot.timeline import Timeline

DAY = 86400  # s

odom_rates = st.one_of(
    st.floats(0.1, 1000), st.sampled_from([0.1, 1.0, 10.0, 20.0, 30.0, 50.0, 100.0, 1000.0]))


@pytest.mark.parametrize('odom_rate, step_rate, steps_per_clock, steps_per_odometry', [
    (20.0, 240.0, 12, 12), (50.0, 250.0, 5, 5), (10.0, 240.0, 12, 24), (1.0, 240.0, 12, 240),
    (1000.0, 1000.0, 1, 1), (0.1, 240.0, 12, 2400)])
def test_the_physics_runs_at_240_hz_or_little_more(
        odom_rate, step_rate, steps_per_clock, steps_per_odometry):
    """As many whole steps as fit between two odometries, and between two ticks of the clock."""
    timeline = Timeline(odom_rate)
    assert timeline.step_rate == pytest.approx(step_rate)
    assert timeline.steps_per_clock == steps_per_clock
    assert timeline.steps_per_odometry == steps_per_odometry


@given(odom_rates)
def test_physics_and_clock_are_fast_enough_for_any_odometry(odom_rate):
    """The clock ticks with each odometry, and between them if a controller needs it."""
    timeline = Timeline(odom_rate)
    assert timeline.step_rate >= 240 * (1 - 1e-9)
    assert timeline.step_rate / timeline.steps_per_clock >= 20 * (1 - 1e-9)
    assert timeline.steps_per_odometry % timeline.steps_per_clock == 0


@given(odom_rates, st.integers(0, DAY))
def test_odometry_is_on_time_to_the_nanosecond_for_a_day(odom_rate, seconds):
    """The time is computed from a count and never summed up."""
    timeline = Timeline(odom_rate)
    number = int(seconds * odom_rate)
    now = timeline.time_of(number * timeline.steps_per_odometry)
    assert isinstance(now, int)
    assert abs(now - number * 10**9 / Fraction(odom_rate)) <= 1


@given(odom_rates, st.integers(0, 1000 * DAY))
def test_time_advances_with_every_step(odom_rate, steps):
    """By the length of a step, give or take the nanosecond it is rounded to."""
    timeline = Timeline(odom_rate)
    step = timeline.time_of(steps + 1) - timeline.time_of(steps)
    assert step == pytest.approx(1e9 / timeline.step_rate, abs=1.01)


@pytest.mark.parametrize('odom_rate, clock_rate', [(20, 20), (50, 50), (10, 20), (3, 21), (1, 20)])
def test_a_second_has_as_many_messages_as_promised(odom_rate, clock_rate):
    """Odometry at its rate, the clock at least at 20 Hz, and always one with the odometry."""
    timeline = Timeline(float(odom_rate))
    clocks, odometries = 0, 0
    while timeline.now < 1e9:
        timeline.steps += 1
        clocks += timeline.clock_is_due
        odometries += timeline.odometry_is_due
        assert timeline.clock_is_due or not timeline.odometry_is_due
        assert timeline.odometry_count == odometries
    assert (clocks, odometries) == (clock_rate, odom_rate)
    assert timeline.now == 10**9


@pytest.mark.parametrize('odom_rate', [20.0, 50.0, 3.0, 1.0, 1000.0])
def test_the_next_tick_of_the_clock_is_the_first_one_to_come(odom_rate):
    """At a tick it is the one after it."""
    timeline = Timeline(odom_rate)
    for steps in range(100):
        timeline.steps = steps
        expected = timeline.next_clock
        timeline.steps += 1
        while not timeline.clock_is_due:
            timeline.steps += 1
        assert timeline.steps == expected


def test_time_starts_at_zero_and_can_start_again():
    """As after a reset of the simulation."""
    timeline = Timeline(20.0)
    assert (timeline.now, timeline.odometry_count) == (0, 0)
    timeline.steps = 240
    assert (timeline.now, timeline.odometry_count) == (10**9, 20)
    timeline.steps = 0
    assert (timeline.now, timeline.odometry_count) == (0, 0)
