"""What the detector makes of stamps that are missing, bunched or late, or start again."""

import pytest
from moved_distance.distance_counter import DistanceCounter

PERIOD = 0.05  # s between two messages at 20 Hz
NO_STAMP = 0.0


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
    assert drive_along(counter, [NO_STAMP] * len(arrivals), step, arrivals) == []
    assert counter.distance == pytest.approx((len(arrivals) - 1) * step)


@pytest.mark.parametrize('bunch', [2, 3, 10, 40])
def test_stamps_in_bunches_of_any_size_lose_nothing(counter, bunch):
    """At 50 Hz, after an even second; forty messages come 0.8 s after those before."""
    even = [number / 50 for number in range(-51, 0)]
    bunched = [number // bunch * bunch / 50 + number % bunch * 1e-4 for number in range(9 * bunch)]
    assert drive_along(counter, even + bunched, 0.7 / 50) == []


def test_a_faster_row_of_messages_is_soon_the_usual_one():
    """After half a second at 20 Hz what was usual at 2 Hz is forgotten; 1 Hz never was usual."""
    for period, forgotten in ((0.5, 11), (1.0, 1)):
        slow = [number * period for number in range(10)]
        fast = [slow[-1] + number * PERIOD for number in range(1, forgotten + 1)]
        counter = DistanceCounter()
        drive_along(counter, [*slow, *fast], 0.0)
        assert counter.add(0.5, 0, fast[-1] + PERIOD, arrival=0.0)


def test_two_robots_on_one_topic_do_not_add_up():
    for offset in (0.01, 0.025, 0.0499, -0.02, -1.0):
        counter = DistanceCounter()
        for number in range(200):
            counter.add(number * 0.005, 0, 10 + number * PERIOD, arrival=0.0)
            counter.add(100, 0, 10 + number * PERIOD + offset, arrival=0.0)
        assert counter.distance <= 1.0
