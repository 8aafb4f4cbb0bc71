"""How far the detector believes the robot has moved."""

import math
import random
from itertools import pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from moved_distance.distance_counter import DistanceCounter

PERIOD = 0.05  # s between two messages at 20 Hz
NO_STAMP = 0.0

coordinates = st.floats(-1e4, 1e4)
points = st.tuples(coordinates, coordinates)
paths = st.lists(points, min_size=1, max_size=30)


@st.composite
def drives(draw):
    """Draw (x, y, stamp) along a drive that stays under the default ~max_speed."""
    (x, y), stamp = draw(points), draw(st.floats(0, 1e9))
    rows = [(x, y, stamp)]
    steps = st.tuples(st.floats(0, 4.9), st.floats(0, 2 * math.pi), st.floats(0.01, 10))
    for speed, direction, duration in draw(st.lists(steps, max_size=30)):
        x += speed * duration * math.cos(direction)
        y += speed * duration * math.sin(direction)
        stamp += duration
        rows.append((x, y, stamp))
    return rows


def count(counter, positions):
    """Add positions at 20 Hz; return the distances after each, and what was not counted."""
    distances, jumps = [], []
    for number, (x, y) in enumerate(positions):
        jumps.append(counter.add(x, y, number * PERIOD, number * PERIOD))
        distances.append(counter.distance)
    return distances, [jump for jump in jumps if jump]


def length(positions):
    """Return the tutorial's sum: one hypot after the other."""
    total = 0.0
    for (x, y), (next_x, next_y) in pairwise(positions):
        total += math.hypot(next_x - x, next_y - y)
    return total


@given(drives())
@example([(0.0, 0.0, 0.0), (1e-7, 0.0, 0.1), (1e-6, 0.0, 0.2)])
def test_the_distance_is_the_sum_of_the_tutorial_to_the_last_bit(rows):
    """With the defaults, after each message, and a total under a micrometre is zero."""
    counter = DistanceCounter()
    for number, (x, y, stamp) in enumerate(rows, 1):
        assert counter.add(x, y, stamp, arrival=0.0) is None
        total = length([row[:2] for row in rows[:number]])
        assert counter.distance == (total if total >= 1e-6 else 0.0)


@given(paths, st.floats(-math.pi, math.pi), points)
def test_the_distance_does_not_depend_on_the_frame(path, turn, offset):
    """Turning and shifting the odom frame changes no length."""
    def moved(x, y):
        return (offset[0] + x * math.cos(turn) - y * math.sin(turn),
                offset[1] + x * math.sin(turn) + y * math.cos(turn))

    here, _ = count(DistanceCounter(max_speed=0), path)
    there, _ = count(DistanceCounter(max_speed=0), [moved(x, y) for x, y in path])
    assert there == pytest.approx(here, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize('step, expected', [(9e-7, 0.0), (1e-6, 1e-6), (2e-6, 2e-6)])
def test_less_than_a_micrometre_is_published_as_zero(step, expected):
    """And not as a number that a reader takes for motion."""
    distances, _ = count(DistanceCounter(), [(0, 0), (step, 0)])
    assert distances == [0.0, expected]


def test_small_steps_add_up_to_more_than_a_micrometre():
    """What is published as zero is not forgotten."""
    distances, _ = count(DistanceCounter(), [(number * 4e-7, 0) for number in range(11)])
    assert distances[:3] == [0.0, 0.0, 0.0]
    assert distances[-1] == pytest.approx(4e-6)


def test_the_first_position_is_no_movement():
    """Wherever the odometry starts."""
    assert count(DistanceCounter(), [(1000, -1000)]) == ([0.0], [])


def test_trembling_below_min_step_is_not_counted():
    """The reference stays where it was, so that noise around it adds nothing."""
    distances, _ = count(DistanceCounter(min_step=0.01), [(0, 0), (0.009, 0)] * 100)
    assert distances[-1] == 0.0


def test_slow_motion_adds_up_past_min_step():
    """One metre in steps of a millimetre is one metre, but for what is not yet counted."""
    path = [(number / 1000, 0) for number in range(1001)]
    distances, _ = count(DistanceCounter(min_step=0.0105), path)
    assert 1 - 0.0105 < distances[-1] <= 1
    assert sorted(set(distances)) == pytest.approx([n * 0.011 for n in range(91)])


@given(st.floats(0.01, 100), paths)
def test_min_step_never_lengthens_a_way(min_step, path):
    """Each counted step is a chord of what it stands for."""
    whole, _ = count(DistanceCounter(max_speed=0), path)
    chords, _ = count(DistanceCounter(min_step, max_speed=0), path)
    assert chords[-1] <= whole[-1] * (1 + 1e-9)


@pytest.mark.parametrize('max_speed, counted', [(5.0, False), (100.0, False), (401.0, True),
                                                (0.0, True)])
def test_a_teleport_is_not_counted_unless_the_speed_is_allowed(max_speed, counted):
    """20 m in a 20th of a second is 400 m/s; the drive goes on from where the robot now is."""
    distances, jumps = count(DistanceCounter(max_speed=max_speed), [(0, 0), (20, 0), (20.1, 0)])
    assert distances == pytest.approx([0, 20, 20.1] if counted else [0, 0, 0.1])
    assert len(jumps) == (0 if counted else 1)


def test_exactly_the_largest_speed_is_counted():
    """The limit itself is allowed, by stamps as by arrival."""
    for stamp in (1.0, NO_STAMP):
        counter = DistanceCounter(max_speed=5.0)
        counter.add(0, 0, NO_STAMP, arrival=0.0)
        assert counter.add(5, 0, stamp, arrival=1.0) is None
        assert counter.distance == 5.0


def test_stamps_count_and_not_arrivals_where_they_advance():
    """Messages that come late and all at once were measured at their stamps."""
    counter = DistanceCounter()
    for number in range(100):
        assert counter.add(number * 0.2, 0, number * PERIOD, arrival=10.0) is None
    assert counter.distance == pytest.approx(99 * 0.2)


def test_a_driver_without_stamps_is_judged_by_arrival():
    """A metre is a walk in a second and a jump in a 20th of it."""
    counter = DistanceCounter()
    counter.add(0, 0, NO_STAMP, arrival=10.0)
    assert counter.add(1, 0, NO_STAMP, arrival=11.0) is None
    jump = counter.add(2, 0, NO_STAMP, arrival=11.05)
    assert jump and 'is faster than ~max_speed' in jump
    assert counter.distance == 1.0


def test_messages_without_stamps_that_arrive_in_a_burst_are_all_counted():
    """A hiccup of the network delays six messages to the arrival of a seventh."""
    counter = DistanceCounter()
    arrivals = [0.0, 0.05, *[0.4] * 7, 0.45]
    for number, arrival in enumerate(arrivals):
        assert counter.add(number * 0.035, 0, NO_STAMP, arrival) is None
    assert counter.distance == pytest.approx(9 * 0.035)


def test_a_long_silence_does_not_excuse_a_teleport_afterwards():
    """The step that ends the gap may be long; the next one has a 20th of a second."""
    counter = DistanceCounter()
    counter.add(0, 0, NO_STAMP, arrival=0.0)
    counter.add(1, 0, NO_STAMP, arrival=60.0)
    jump = counter.add(3, 0, NO_STAMP, arrival=60.05)
    assert jump and 'is faster than ~max_speed' in jump
    assert counter.distance == 1.0


def test_a_stamp_that_goes_back_starts_a_new_stretch():
    """A looping bag leaps from its end to its beginning, and that leap is no movement."""
    counter = DistanceCounter()
    bag = [(0.0, 0.0), (0.1, 1.0), (0.2, 2.0)]
    jumps = [counter.add(x, 0, stamp, arrival=0.0) for x, stamp in bag * 3]
    assert counter.distance == pytest.approx(3 * 0.2)
    assert [number for number, jump in enumerate(jumps) if jump] == [3, 6]
    assert jumps[3] == 'the time stamp went back by 2.000 s'


def drive_along(counter, stamps, step):
    """Go a step (m) per message along x, each message as late as its stamp; return the jumps."""
    jumps = [counter.add(number * step, 0, stamp, arrival=stamp)
             for number, stamp in enumerate(stamps)]
    return [jump for jump in jumps if jump]


def stamps_of_a_driver_that_stalls(count, rate):
    """Return stamps (s) as now() gives them: each twentieth message or so holds up those behind it."""
    numbers, free, stamps = random.Random(1), 0.0, []
    for number in range(count):
        if numbers.random() < 0.05:
            free = max(free, number / rate) + numbers.uniform(0.01, 0.3)
        stamps.append(max(number / rate, free) + number * 1e-5)
    return stamps


@pytest.mark.parametrize('late_one', range(5))
@pytest.mark.parametrize('speed, lateness', [(0.7, 0.019), (0.1, 0.0198), (4.0, 0.0199)])
def test_bunched_stamps_lose_nothing(late_one, speed, lateness):
    """At 50 Hz each fifth message is stamped when the next one is nearly due."""
    stamps = [number / 50 + (lateness if number % 5 == late_one else 0) for number in range(501)]
    counter = DistanceCounter()
    assert drive_along(counter, stamps, speed / 50) == []
    assert counter.distance == pytest.approx(10 * speed)


@pytest.mark.parametrize('bunch', [2, 3, 10, 40])
def test_stamps_in_bunches_of_any_size_lose_nothing(bunch):
    """At 50 Hz, after an even second; forty messages come 0.8 s after those before."""
    even = [number / 50 for number in range(-51, 0)]
    bunched = [number // bunch * bunch / 50 + number % bunch * 1e-4 for number in range(9 * bunch)]
    assert drive_along(DistanceCounter(), even + bunched, 0.7 / 50) == []


def test_stamps_of_a_driver_under_load_lose_nothing():
    """It stamps with now(), when it gets the processor."""
    counter = DistanceCounter()
    assert drive_along(counter, stamps_of_a_driver_that_stalls(2001, rate=50), 0.7 / 50) == []
    assert counter.distance == pytest.approx(28.0)


def test_a_burst_after_a_long_silence_loses_nothing():
    """A network that was away for a minute delivers what a driver without stamps sent before."""
    counter = DistanceCounter()
    arrivals = [*(number * 0.02 for number in range(50)), *[60.0] * 100]
    for number, arrival in enumerate(arrivals):
        assert counter.add(number * 0.014, 0, NO_STAMP, arrival) is None


@pytest.mark.parametrize('first', [1, 2, 3, 19, 20, 21, 200])
def test_a_jump_between_even_stamps_stays_one(first):
    """0.26 m in a 20th of a second, from the second message on."""
    counter = DistanceCounter()
    stamps = [number * PERIOD for number in range(first)]
    assert drive_along(counter, stamps, 0.005) == []
    assert counter.add(first * 0.005 + 0.26, 0, first * PERIOD, arrival=first * PERIOD)


@pytest.mark.parametrize('number', range(10, 15))
def test_a_jump_among_bunched_stamps_stays_one(number):
    """Whichever message of the five it is."""
    counter = DistanceCounter()
    stamps = [n * PERIOD + (0.049 if n % 5 == 4 else 0) for n in range(number + 1)]
    drive_along(counter, stamps[:-1], 0.005)
    assert counter.add(number * 0.005 + 0.52, 0, stamps[-1], arrival=stamps[-1])


def test_a_faster_row_of_messages_is_soon_the_usual_one():
    """After half a second at 20 Hz what was usual at 2 Hz is forgotten; 1 Hz never was usual."""
    for period, forgotten in ((0.5, 11), (1.0, 1)):
        slow = [number * period for number in range(10)]
        fast = [slow[-1] + number * PERIOD for number in range(1, forgotten + 1)]
        counter = DistanceCounter()
        drive_along(counter, [*slow, *fast], 0.0)
        assert counter.add(0.5, 0, fast[-1] + PERIOD, arrival=0.0)


def test_two_robots_on_one_topic_do_not_add_up():
    """A hundred metres apart, their stamps in turn: each message is a jump, whoever is late."""
    for offset in (0.01, 0.025, 0.0499, -0.02, -1.0):
        counter = DistanceCounter()
        for number in range(200):
            counter.add(number * 0.005, 0, 10 + number * PERIOD, arrival=0.0)
            counter.add(100, 0, 10 + number * PERIOD + offset, arrival=0.0)
        assert counter.distance <= 1.0


def test_a_swapped_pair_counts_each_step_once():
    """The one that comes late is ignored, also for the step after it."""
    counter = DistanceCounter()
    jumps = [counter.add(number * 0.01, 0, number * PERIOD, arrival=0.0)
             for number in (0, 1, 2, 4, 3, 5, 6)]
    assert counter.distance == pytest.approx(0.06)
    assert [number for number, jump in enumerate(jumps) if jump] == [4]


def test_messages_that_are_repeated_late_count_nothing():
    """One in a hundred comes again, even twice, after the fifth one behind it."""
    counter = DistanceCounter()
    for number in range(1000):
        counter.add(number * 0.01, 0, number * PERIOD, arrival=0.0)
        for _ in range(2 if number % 100 == 50 else 0):
            counter.add((number - 5) * 0.01, 0, (number - 5) * PERIOD, arrival=0.0)
    assert counter.distance == pytest.approx(9.99)


def test_time_restarts_when_a_second_message_goes_on_from_an_older_one():
    """A simulator that was reset: its robot is elsewhere, and counted from there."""
    counter = DistanceCounter()
    messages = [(5.0, 100.0), (5.1, 100.05), (0.0, 0.0), (0.01, 0.05), (0.03, 0.1)]
    distances = []
    for x, stamp in messages:
        counter.add(x, 0, stamp, arrival=0.0)
        distances.append(counter.distance)
    assert distances == pytest.approx([0, 0.1, 0.1, 0.11, 0.13])


def test_a_driver_that_no_longer_stamps_its_messages_is_counted_on():
    """Its stamps fall to zero and stay there; but for the first step nothing is lost."""
    counter = DistanceCounter()
    drive_along(counter, [100 + number * PERIOD for number in range(11)], 0.01)
    for number in range(11, 21):
        counter.add(number * 0.01, 0, NO_STAMP, arrival=100 + number * PERIOD)
    assert counter.distance == pytest.approx(0.19)


@pytest.mark.parametrize('x, y', [(math.nan, 0), (0, math.nan), (math.inf, 0), (0, -math.inf)])
def test_a_position_that_is_not_finite_is_refused_and_changes_nothing(x, y):
    """Also not the position from which the next step is measured."""
    counter = DistanceCounter()
    counter.add(1, 1, 0.0, arrival=0.0)
    counter.add(2, 1, 1.0, arrival=1.0)
    with pytest.raises(ValueError, match='is not finite'):
        counter.add(x, y, 2.0, arrival=2.0)
    assert counter.distance == 1.0
    counter.add(3, 1, 3.0, arrival=3.0)
    assert counter.distance == 2.0


def test_a_reset_counts_from_the_last_position():
    """Not from the last counted one: what was not counted yet is dropped too."""
    counter = DistanceCounter(min_step=0.5, max_speed=0)
    count(counter, [(0, 0), (0.6, 0), (1.0, 0)])
    counter.reset()
    assert counter.distance == 0.0
    counter.add(1.4, 0, 1.0, arrival=1.0)
    assert counter.distance == 0.0
    counter.add(1.5, 0, 2.0, arrival=2.0)
    assert counter.distance == 0.5


any_number = st.one_of(st.floats(), st.sampled_from([1e308, -1e308, 1.7e308, 5e-324]), coordinates)
events = st.one_of(
    st.just('reset'),
    st.tuples(any_number, any_number, st.floats(0, 1e3), st.floats(0, 1e3)))


@given(st.floats(0, 1e308), st.floats(0, 1e308), st.lists(events, max_size=40))
@example(1.7e308, 0.0, [(0, 0, 0, 0), (1.6e308, 0, 1, 1), (1.6e308, 1.6e308, 2, 2)])
def test_whatever_arrives_the_distance_is_finite_and_falls_only_by_a_reset(
        min_step, max_speed, sequence):
    """NaN, jumps of the largest numbers, stamps in any order, resets at any time."""
    counter = DistanceCounter(min_step, max_speed)
    before = 0.0
    for event in sequence:
        if event == 'reset':
            counter.reset()
            before = 0.0
            assert counter.distance == 0.0
            continue
        try:
            counter.add(*event)
        except ValueError:
            assert not all(map(math.isfinite, event)) and counter.distance == before
        assert before <= counter.distance < math.inf
        before = counter.distance
