"""Simulated time, counted in physics steps."""

import math

MIN_STEP_RATE = 240  # Hz; PyBullet's own default
MIN_CLOCK_RATE = 20  # Hz; a controller at 10 Hz needs a clock that is finer than its period


class Timeline:
    """Counts physics steps; every odometry message and every clock tick falls on a step.

    Times are integer nanoseconds computed from the count, so that no rounding adds up.
    """

    def __init__(self, odom_rate):
        """Divide the time between two odometry messages (rate in Hz)."""
        self.odom_rate = odom_rate
        clock_ticks = math.ceil(MIN_CLOCK_RATE / odom_rate)
        self.steps_per_clock = math.ceil(MIN_STEP_RATE / (odom_rate * clock_ticks))
        self.steps_per_odometry = self.steps_per_clock * clock_ticks
        self.step_rate = odom_rate * self.steps_per_odometry
        self.steps = 0

    @property
    def now(self):
        """Simulated time (ns)."""
        return self.time_of(self.steps)

    def time_of(self, steps):
        """Return the simulated time (ns) after so many steps."""
        return round(steps * 1e9 / self.step_rate)

    @property
    def next_clock(self):
        """The step of the next tick of the clock."""
        return self.steps - self.steps % self.steps_per_clock + self.steps_per_clock

    @property
    def clock_is_due(self):
        """Whether this step is a tick of the clock."""
        return self.steps % self.steps_per_clock == 0

    @property
    def odometry_is_due(self):
        """Whether this step is one with odometry."""
        return self.steps % self.steps_per_odometry == 0

    @property
    def odometry_count(self):
        """How many odometry messages there have been before this step."""
        return self.steps // self.steps_per_odometry
