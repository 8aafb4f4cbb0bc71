"""How messages usually follow each other."""

from collections import deque


class UsualPeriod:
    """The mean time between messages, over the last second in which there were any.

    A mean, because messages that come late leave it as it is: what one interval lacks, another
    has too much. Over a time and not a number of messages, because a hundred of them in one burst
    then weigh no more than the pause before, and a new rate soon prevails. A longer silence
    is not how messages usually follow each other, and is left out.
    """

    WINDOW = 1.0  # s
    FIRST_GUESS = 0.05  # s, until there was an interval; the tutorial's robot sends at 20 Hz
    LARGEST_COUNT = 1000  # messages in the window

    def __init__(self):
        """Begin with the first message."""
        # When the messages were, by a clock that stands still in each silence.
        self._times = deque([0.0], self.LARGEST_COUNT)

    @property
    def mean(self):
        """Seconds."""
        intervals = len(self._times) - 1
        return (self._times[-1] - self._times[0]) / intervals if intervals else self.FIRST_GUESS

    def add(self, interval):
        """Take the time from one message to the next (s)."""
        if interval >= self.WINDOW:
            return
        self._times.append(self._times[-1] + interval)
        while self._times[-1] - self._times[0] > self.WINDOW:
            self._times.popleft()
