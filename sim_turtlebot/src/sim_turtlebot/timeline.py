"""Simulated time, counted in physics steps and in ticks of the clock."""

import math

MIN_STEP_RATE = 240  # Hz; PyBullet's own default
MIN_CLOCK_RATE = 20  # Hz; a controller at 10 Hz needs more than one tick per period


class Timeline:
    """Counts physics steps and ticks of the clock, which may fall between two steps.

    Every odometry message falls on a step and on a tick. Times are integer nanoseconds computed
    from the counts, so rounding errors do not add up. The physics and the time of the odometry
    depend on the rate of the odometry alone.
    """

    def __init__(self, odom_rate, clock_rate=0.0):
        """Divide the time between two odometry messages.

        :param odom_rate: odometry messages per second (Hz)
        :param clock_rate: ticks of the clock per second (Hz), rounded up to a multiple of
            odom_rate; 0: as few as MIN_CLOCK_RATE allows
        """
        self.odom_rate = odom_rate
        coarsest = math.ceil(MIN_CLOCK_RATE / odom_rate)
        self.steps_per_odometry = coarsest * math.ceil(MIN_STEP_RATE / (odom_rate * coarsest))
        ticks = math.ceil(clock_rate / odom_rate - 1e-9)  # a rounding error is no tick
        self.ticks_per_odometry = ticks if clock_rate else coarsest
        self.step_rate = odom_rate * self.steps_per_odometry
        self.restart()

    def restart(self):
        """Go back to time zero."""
        self.steps = self.ticks = 0
        self.now = 0  # simulated time (ns)
        self.clock_is_due = True  # whether the clock ticks now

    def advance(self, last_step=math.inf):
        """Go to the next tick of the clock, or to the step `last_step` if that comes first."""
        next_tick = (self.ticks + 1) * self.steps_per_odometry
        self.clock_is_due = next_tick <= last_step * self.ticks_per_odometry
        if self.clock_is_due:
            self.ticks += 1
            self.steps = next_tick // self.ticks_per_odometry
            self.now = self.time_of(next_tick / self.ticks_per_odometry)
        else:
            self.steps = last_step
            self.now = self.time_of(last_step)

    def time_of(self, steps):
        """Return the simulated time (ns) after this many steps."""
        return round(steps * 1e9 / self.step_rate)

    @property
    def odometry_is_due(self):
        """Whether odometry is due now."""
        return self.clock_is_due and self.ticks % self.ticks_per_odometry == 0

    @property
    def odometry_count(self):
        """How many odometry periods have passed."""
        return self.steps // self.steps_per_odometry
