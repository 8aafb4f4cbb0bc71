"""When a loop with rospy.Rate runs, by the ticks of simulated time."""


class Rate:
    """Does what rospy.Rate and rospy.sleep() do, in integer nanoseconds from the first tick on."""

    def __init__(self, hertz):
        self._period = int(1e9 / hertz)
        self._last = None  # start of the period
        self._sleep = self._end = 0  # duration and end of the current sleep
        self._waits_for_time = False

    def is_due(self, now):
        """Return whether the loop runs at a tick of the clock.

        :param now: time of the tick (ns)
        """
        if self._waits_for_time:  # rospy.sleep() starts at the first time after zero
            self._waits_for_time, self._end = False, now + self._sleep
        if now < self._end:
            return False
        if self._last is None:
            self._last = now
        self._sleep = 0
        while self._sleep <= 0:  # a late loop runs again at once
            self._sleep = self._period - (now - self._last)
            self._last += self._period
            if now - self._last > 2 * self._period:
                self._last = now
        self._end = now + self._sleep
        self._waits_for_time = now == 0
        return True
