"""When a loop with rospy.Rate runs in simulated time, by the ticks of its clock."""


class Rate:
    """Computes in whole nanoseconds what rospy.Rate and rospy.sleep() do, from the first tick on."""

    def __init__(self, hertz):
        """Take the rate of the loop (Hz)."""
        self._period = int(1e9 / hertz)
        self._last = None  # when the period began
        self._sleep = self._end = 0  # how long the loop sleeps, and until when
        self._waits_for_time = False

    def is_due(self, now):
        """Return whether the loop runs at a tick of the clock.

        :param now: time of the tick (ns)
        """
        if self._waits_for_time:  # rospy.sleep() begins once there is a time other than zero
            self._waits_for_time, self._end = False, now + self._sleep
        if now < self._end:
            return False
        if self._last is None:
            self._last = now
        self._sleep = 0
        while self._sleep <= 0:  # a loop that is late runs again at once
            self._sleep = self._period - (now - self._last)
            self._last += self._period
            if now - self._last > 2 * self._period:
                self._last = now
        self._end = now + self._sleep
        self._waits_for_time = now == 0
        return True
