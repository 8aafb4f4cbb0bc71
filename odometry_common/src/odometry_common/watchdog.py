"""For controllers: notice when a stream of messages falls silent."""

import math
import time
from collections import deque

WALL_SILENCE = 0.2  # s
# Two clocks: time has gone back JUMPS times within JUMP_MEMORY s of wall time.
JUMPS, JUMP_MEMORY = 2, 10.0


class Watchdog:
    """Notices when a stream of messages falls silent."""

    def __init__(self, timeout):
        """Allow `timeout` seconds between arrivals; 0 turns the watchdog off.

        It also requires WALL_SILENCE of wall time, or a shorter timeout: simulated time can run
        a hundred times as fast, and a subscriber may see it leap by seconds. While time goes back
        again and again, as with two clocks, it requires `timeout` of wall time.
        """
        self._timeout = timeout
        self._fed = None  # time and wall time of the last arrival
        self._latest = -math.inf
        self._went_back = deque(JUMPS * [-math.inf], maxlen=JUMPS)  # wall times

    def feed(self, now):
        """Record an arrival at `now` (s)."""
        self._look_for_jump(now)
        self._fed = now, time.monotonic()

    def expired(self, now):
        """Return whether the last arrival is more than the timeout ago; never before the first.

        If time has gone back (a simulator was reset), the timeout starts again.
        """
        if self._timeout == 0 or self._fed is None:
            return False
        self._look_for_jump(now)
        fed, fed_wall = self._fed
        if now < fed:
            self._fed = now, fed_wall
            return False
        two_clocks = time.monotonic() - self._went_back[0] < JUMP_MEMORY
        wall_timeout = self._timeout if two_clocks else min(self._timeout, WALL_SILENCE)
        return now - fed > self._timeout and time.monotonic() - fed_wall >= wall_timeout

    def _look_for_jump(self, now):
        if now < self._latest:
            self._went_back.append(time.monotonic())
        self._latest = now
