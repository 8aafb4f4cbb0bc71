"""How far the detector believes the robot has moved."""

import math

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from moved_distance.distance_counter import DistanceCounter

PERIOD = 0.05  # s between two messages at 20 Hz
NO_STAMP = 0.0

points = st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4))


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
    for (x, y), (next_x, next_y) in zip(positions, positions[1:]):
        total += math.hypot(next_x - x, next_y - y)
    return total


@given(drives())
@example([(0.0, 0.0, 0.0), (9e-7, 0.0, 0.1)])
@example([(0.0, 0.0, 0.0), (1e-6, 0.0, 0.1)])
@example([(number * 4e-7, 0.0, number * 0.1) for number in range(11)])
def test_the_distance_is_the_sum_of_the_tutorial_to_the_last_bit(rows):
    """With the defaults, after each message, and a total under a micrometre is zero."""
    counter = DistanceCounter()
    for number, (x, y, stamp) in enumerate(rows, 1):
        assert counter.add(x, y, stamp, arrival=0.0) is None
        total = length([row[:2] for row in rows[:number]])
        assert counter.distance == (total if total >= 1e-6 else 0.0)


def test_slow_motion_adds_up_past_min_step():
    """One metre in steps of a millimetre is one metre, but for what is not yet counted."""
    path = [(number / 1000, 0) for number in range(1001)]
    distances, _ = count(DistanceCounter(min_step=0.0105), path)
    assert 1 - 0.0105 < distances[-1] <= 1
    assert sorted(set(distances)) == pytest.approx([n * 0.011 for n in range(91)])


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
