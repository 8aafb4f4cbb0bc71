"""Simulated time: every message falls on a physics step, no rounding adds up, and /clock ticks finely."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from odometry_tests.tutorial import simulator
from odometry_tests.waiting import Recorder
from rosgraph_msgs.msg import Clock
from sim_turtlebot.timeline import Timeline

DAY = 86400  # s

odom_rates = st.one_of(
    st.floats(0.1, 1000), st.sampled_from([0.1, 20.0, 1000.0]))
clock_rates = st.one_of(st.just(0.0), st.floats(0.1, 1000))
TICKS = 200


@given(odom_rates, clock_rates)
def test_the_rate_of_the_clock_changes_nothing_else(odom_rate, clock_rate):
    coarse, fine = Timeline(odom_rate), Timeline(odom_rate, clock_rate)
    assert fine.step_rate == coarse.step_rate
    assert times(fine, 3, 'odometry_is_due') == times(coarse, 3, 'odometry_is_due')


@pytest.mark.parametrize('stride', [1, 5, math.inf])
@pytest.mark.parametrize('odom_rate, clock_rate, expected', [
    (20.0, 200.0, 200), (20.0, 50.0, 60), (30.0, 100.0, 120), (1000.0, 1000.0, 1000)])
def test_the_clock_ticks_as_often_as_asked_or_just_more(odom_rate, clock_rate, expected, stride):
    """Evenly, however far the simulation goes at once."""
    timeline = Timeline(odom_rate, clock_rate)
    ticks = times(timeline, odom_rate, 'clock_is_due', stride)
    assert len(ticks) == expected
    assert ticks == [round(number * 1e9 / expected) for number in range(1, expected + 1)]


def times(timeline, odometries, due, stride=1):
    """Go on for so many odometry messages; return the times (ns) at which something was due."""
    seen, last = [], 0
    while timeline.odometry_count < odometries:
        timeline.advance(timeline.steps + stride)
        assert timeline.now > last, 'time has stood still'
        last = timeline.now
        if getattr(timeline, due):
            seen.append(last)
    return seen


@given(odom_rates, st.integers(0, DAY))
def test_odometry_is_on_time_to_the_nanosecond_for_a_day(odom_rate, seconds):
    timeline = Timeline(odom_rate)
    number = int(seconds * odom_rate)
    now = timeline.time_of(number * timeline.steps_per_odometry)
    assert isinstance(now, int)
    assert abs(now - number * 10**9 / Fraction(odom_rate)) <= 1


@pytest.mark.parametrize('arguments, period', [
    ([], 5), (['_real_time_factor:=10'], 10), (['_real_time_factor:=0'], 50),
    (['_real_time_factor:=0', '_clock_rate:=500'], 2)])
def test_the_clock_ticks_with_this_period(simulated_time, arguments, period):
    """In ms; a message that gets lost makes a gap, and none makes it shorter."""
    with simulator(*arguments):
        times = [message.clock.to_nsec() for message in Recorder('/clock', Clock).wait_for_count(TICKS)]
    seen = [time for time in times if time > 1]  # the first tick is a nanosecond, since zero is no time to ROS
    assert all(time % (period * 10**6) == 0 for time in seen)
    assert min(later - sooner for sooner, later in zip(seen, seen[1:])) == period * 10**6
