"""Timing for controllers, over plain seconds: what is due, what is silent, what is at rest."""

import time


class Metronome:
    """Keeps a period, by times that come from elsewhere."""

    def __init__(self, period):
        """Beat every `period` seconds; 0: always."""
        self._period = period
        self._beat = None
        self._due_at = None

    def is_due(self, now):
        """Return whether `now` (s) begins a new period.

        When time goes backwards or leaps, the periods start again.
        """
        in_order = self._due_at is not None and now >= self._due_at
        if in_order and now - self._beat < 0.99 * self._period:  # time stamps are rounded
            return False
        in_row = in_order and now - self._beat < 2 * self._period
        self._beat = self._beat + self._period if in_row else now
        self._due_at = now
        return True


class Watchdog:
    """Notices when a stream of messages has fallen silent."""

    def __init__(self, timeout, wall_timeout=0.0):
        """Allow `timeout` seconds between arrivals; 0 turns the watchdog off.

        :param wall_timeout: s of wall time without an arrival that it takes too. Simulated time can
            run a hundred times as fast, and a subscriber may see it leap by seconds.
        """
        self._timeout = timeout
        self._wall_timeout = wall_timeout
        self._last_fed = None
        self._last_fed_wall = 0.0

    def feed(self, now):
        """Note an arrival at `now` (s)."""
        self._last_fed = now
        self._last_fed_wall = time.monotonic()

    def expired(self, now):
        """Return whether the last arrival is more than the timeout ago; never before the first.

        When time has gone backwards (a simulator was reset) the wait starts again.
        """
        if self._timeout == 0 or self._last_fed is None:
            return False
        self._last_fed = min(self._last_fed, now)
        silent_in_reality = time.monotonic() - self._last_fed_wall >= self._wall_timeout
        return silent_in_reality and now - self._last_fed > self._timeout


class RestDetector:
    """Notices when a measured value has stopped changing."""

    def __init__(self, band, duration):
        """Call it rest when the value stays within `band` of itself for `duration` seconds."""
        self._band = band
        self._duration = duration
        self.reset()

    def reset(self):
        """Forget what was seen."""
        self._value = None
        self._since = None

    def at_rest(self, now, value):
        """Take the `value` measured at `now` (s); return whether it has come to rest."""
        moved = self._value is None or abs(value - self._value) > self._band
        if moved or now < self._since:
            self._value, self._since = value, now
        return now - self._since >= self._duration
