"""What the detector makes of stamps that are missing, bunched, late or begin anew."""

import random

import pytest
from moved_distance.distance_counter import DistanceCounter

PERIOD = 0.05  # s between two messages at 20 Hz
NO_STAMP = 0.0


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
