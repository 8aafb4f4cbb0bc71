"""What the detector counts, whatever positions, stamps and arrivals are."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from moved_distance.distance_counter import MAX_STEP, DistanceCounter
from odometry_tests.fuzzing import any_number

PERIOD = 0.05  # s between two messages at 20 Hz
NO_STAMP = 0.0
limits = st.one_of(st.just(0.0), st.floats(0, 10), st.floats(0, 1.7e308))
coordinates = st.one_of(st.floats(-10, 10), any_number)
pauses = st.one_of(st.sampled_from([0.0, 0.05]), st.floats(-5, 100))  # s
messages = st.lists(st.tuples(coordinates, coordinates, pauses, st.floats(0, 100)))


@pytest.fixture
def counter():
    return DistanceCounter()


def drive_along(counter, stamps, step, arrivals=None):
    """Go a step (m) per message along x, each message as late as its stamp; return the jumps."""
    jumps = [counter.add(number * step, 0, stamp, arrival)
             for number, (stamp, arrival) in enumerate(zip(stamps, arrivals or stamps))]
    return [jump for jump in jumps if jump]


@pytest.mark.parametrize('pause', [1.0, 60.0])
def test_a_driver_without_stamps_is_judged_by_arrival(counter, pause):
    """A metre is a walk in a second and a jump in a 20th of it, also after a long silence."""
    counter.add(0, 0, NO_STAMP, arrival=10.0)
    assert counter.add(1, 0, NO_STAMP, arrival=10.0 + pause) is None
    jump = counter.add(2, 0, NO_STAMP, arrival=10.05 + pause)
    assert jump and 'is faster than ~max_speed' in jump
    assert counter.distance == 1.0


@pytest.mark.parametrize('arrivals, step', [
    ([0.0, 0.05, *[0.4] * 7, 0.45], 0.035),  # six messages come when the seventh does
    ([*(number * 0.02 for number in range(50)), *[60.0] * 100], 0.014),  # a minute without network
])
def test_messages_without_stamps_that_arrive_in_a_burst_are_all_counted(counter, arrivals, step):
    assert not drive_along(counter, [NO_STAMP] * len(arrivals), step, arrivals)
    assert counter.distance == pytest.approx((len(arrivals) - 1) * step)


@pytest.mark.parametrize('bunch', [2, 3, 10, 40])
def test_stamps_in_bunches_of_any_size_lose_nothing(counter, bunch):
    """At 50 Hz, after an even second; forty messages come 0.8 s after those before."""
    even = [number / 50 for number in range(-51, 0)]
    bunched = [number // bunch * bunch / 50 + number % bunch * 1e-4 for number in range(9 * bunch)]
    assert not drive_along(counter, even + bunched, 0.7 / 50)


def test_a_faster_row_of_messages_is_soon_the_usual_one():
    """After half a second at 20 Hz what was usual at 2 Hz is forgotten; 1 Hz never was usual."""
    for period, forgotten in ((0.5, 11), (1.0, 1)):
        slow = [number * period for number in range(10)]
        fast = [slow[-1] + number * PERIOD for number in range(1, forgotten + 1)]
        counter = DistanceCounter()
        drive_along(counter, [*slow, *fast], 0.0)
        assert counter.add(0.5, 0, fast[-1] + PERIOD, arrival=0.0)


@pytest.mark.parametrize('messages, distance', [
    ([(0, 5.0), (1, 6.0), (0.5, 5.5), (2, 7.0)], 2.0),  # overtaken by another one
    ([(0, 5.0), (1, 6.0), (0.5, 5.5), (0.5, 5.5), (2, 7.0)], 2.0),  # and repeated
    ([(0, 5.0), (1, 6.0), (0.25, 0.0), (0.5, 1.0), (1, 2.0)], 1.75),  # a simulator was reset
    ([(0, 5.0), (9e-7, 6.0)], 0.0)])  # less than a micrometre
def test_a_late_message_counts_nothing_unless_time_has_started_again(counter, messages, distance):
    for x, stamp in messages:
        counter.add(x, 0, stamp, arrival=0.0)
    assert counter.distance == distance


def test_two_robots_on_one_topic_do_not_add_up():
    for offset in 0.01, 0.025, 0.0499, -0.02, -1.0:
        counter = DistanceCounter()
        for number in range(200):
            counter.add(number * 0.005, 0, 10 + number * PERIOD, arrival=0.0)
            counter.add(100, 0, 10 + number * PERIOD + offset, arrival=0.0)
        assert counter.distance <= 1.0


@given(limits, limits, messages)
def test_it_never_falls_and_is_always_a_number(min_step, max_speed, messages):
    """Whatever time does; a position is refused exactly if it is not finite."""
    counter, stamp, arrival, before = DistanceCounter(min_step, max_speed), 100.0, 100.0, 0.0
    for x, y, pause, delay in messages:
        stamp, arrival = max(0.0, stamp + pause), arrival + delay
        try:
            counter.add(x, y, stamp, arrival)
        except ValueError:
            assert not (math.isfinite(x) and math.isfinite(y))
        else:
            assert math.isfinite(x) and math.isfinite(y)
        assert before <= counter.distance < math.inf
        before = counter.distance


@given(limits, st.lists(st.tuples(coordinates, coordinates)), st.integers(0, 20))
@example(0.5, [(0.0, 0.0), (0.25, 0.0), (0.75, 0.0)], 1)
def test_without_a_limit_of_speed_it_is_the_sum_of_the_steps_to_the_bit(min_step, places, reset_at):
    """Zero below a micrometre; each step from where the last counted one ended, or from a reset."""
    counter, total, reference = DistanceCounter(min_step, max_speed=0.0), 0.0, None
    for number, place in enumerate(place for place in places if all(map(math.isfinite, place))):
        counter.add(*place, stamp=float(number), arrival=0.0)
        step = reference and math.hypot(place[0] - reference[0], place[1] - reference[1])
        if reference is None or step > MAX_STEP:
            reference = place
        elif step >= min_step:
            total, reference = total + step, place
        if number == reset_at:
            counter.reset()
            total, reference = 0.0, place
    assert counter.distance == (total if total >= 1e-6 else 0.0)
