"""The detector's sum under any sequence of messages, gaps, resets and strange values."""

import math

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule
from moved_distance.distance_counter import MAX_STEP, DistanceCounter
from odometry_tests.fuzzing import any_number

FIRST_PERIOD = 0.05  # s, usual between two messages until there were some
SILENCE = 1.0  # s; no usual time between messages is that long

limits = st.one_of(st.just(0.0), st.floats(0, 10), st.floats(0, 1.7e308))
durations = st.one_of(st.sampled_from([0.0, 0.05]), st.floats(0, 100))


class DetectorMachine(RuleBasedStateMachine):
    """A robot that drives, jumps, falls silent and lies, beside a model of the sum.

    The model keeps every counted step in a list. Whether a step counts it decides only where
    the contract does; which of the times between messages is the usual one is the detector's
    choice.
    """

    @initialize(min_step=limits, max_speed=st.one_of(st.just(5.0), limits))
    def start(self, min_step, max_speed):
        self.min_step, self.max_speed = min_step, max_speed
        self.counter = DistanceCounter(min_step, max_speed)
        self.stamp = self.arrival = 100.0
        self.stamped = True
        self.last = self.reference = self.late = None
        self.periods = [FIRST_PERIOD]
        self.steps = []
        self.previous = 0.0

    @rule(duration=durations)
    def time_passes(self, duration):
        self.arrival += duration
        if self.stamped:
            self.stamp += duration

    @rule(duration=durations)
    def the_clock_goes_back(self, duration):
        """Reset the simulator, or loop a bag."""
        self.stamp = max(0.0, self.stamp - duration)

    @rule()
    def the_driver_changes(self):
        self.stamped = not self.stamped

    @rule(speed=st.floats(0, 10), direction=st.floats(0, math.tau), duration=durations)
    def drive(self, speed, direction, duration):
        """Go on from the last position, at a speed that may be too high to be true."""
        self.time_passes(duration)
        x, y = self.last[:2] if self.last else (0.0, 0.0)
        way = speed * duration
        self.hear(x + way * math.cos(direction), y + way * math.sin(direction))

    @rule(x=any_number, y=any_number)
    def jump(self, x, y):
        self.hear(x, y)

    @precondition(lambda self: self.reference)
    @rule()
    def drive_exactly_min_step(self):
        self.time_passes(1.0)
        self.hear(self.reference[0] + self.min_step, self.reference[1])

    @precondition(lambda self: self.last)
    @rule()
    def repeat(self):
        """Hear the last message again, as a simulator in lockstep repeats it."""
        self.hear(*self.last[:2])

    @rule()
    def reset(self):
        self.counter.reset()
        self.steps.clear()
        self.previous = 0.0
        self.reference = self.last and self.last[:2]

    @invariant()
    def it_never_falls_and_is_always_a_number(self):
        distance = self.counter.distance
        assert self.previous <= distance < math.inf
        self.previous = distance

    @invariant()
    def it_is_the_sum_of_the_model(self):
        """To the last bit, and zero below a micrometre."""
        total = 0.0
        for step in self.steps:
            total += step
        assert self.counter.distance == (total if total >= 1e-6 else 0.0)

    def hear(self, x, y):
        message = x, y, self.stamp, self.arrival
        try:
            refused = self.counter.add(*message)
        except ValueError:
            assert not (math.isfinite(x) and math.isfinite(y)), 'a good position was refused'
            return
        assert math.isfinite(x) and math.isfinite(y), 'a bad position was accepted'
        expected = self.must_be_refused(message)
        assert expected in (bool(refused), None), refused or 'a jump was counted'
        if self.late is not message:
            self.count(x, y, refused)
            self.last, self.late = message, None

    def must_be_refused(self, message):
        """Return whether the contract calls this message a jump; None: it leaves that open."""
        x, y, stamp, arrival = message
        if self.last is None:
            return False
        if stamp < self.last[2]:
            if self.late is None or stamp < self.late[2] or message[:3] == self.late[:3]:
                self.late = message
                return True
            self.last, self.reference = self.late, self.late[:2]
        interval = stamp - self.last[2] or max(0.0, arrival - self.last[3])
        usual, self.periods = self.periods, self.periods + [interval] * (interval < SILENCE)
        uncounted = math.hypot(x - self.reference[0], y - self.reference[1])
        if uncounted > MAX_STEP:
            return True
        needed = math.hypot(x - self.last[0], y - self.last[1])
        needed = needed / self.max_speed if self.max_speed else 0.0
        if needed > max(interval, *usual):
            return True
        return False if needed <= max(interval, min(usual)) else None

    def count(self, x, y, refused):
        if refused or self.reference is None:
            self.reference = x, y
            return
        step = math.hypot(x - self.reference[0], y - self.reference[1])
        if step >= self.min_step:
            self.steps.append(step)
            self.reference = x, y


TestDetector = DetectorMachine.TestCase
