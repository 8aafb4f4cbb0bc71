"""How far the detector believes the robot has moved."""

import math

from hypothesis import example, given
from hypothesis import strategies as st
from moved_distance.distance_counter import DistanceCounter

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


def test_exactly_the_largest_speed_is_counted():
    """The limit itself is allowed, by stamps as by arrival."""
    for stamp in (1.0, NO_STAMP):
        counter = DistanceCounter(max_speed=5.0)
        counter.add(0, 0, NO_STAMP, arrival=0.0)
        assert counter.add(5, 0, stamp, arrival=1.0) is None
        assert counter.distance == 5.0
