"""What the pad's buttons command: who holds which, and what that means for the robot."""

HOLD_RATE = 10.0  # Hz, at which the page says that a button is still held
HOLD_TIMEOUT = 0.5  # s without that after which it counts as released
COMMAND_PERIOD = 0.05  # s

FORWARD, BACK, LEFT, RIGHT, STOP = 'forward', 'back', 'left', 'right', 'stop'
# Shares of the greatest speed forwards and to the left.
STANDSTILL = 0, 0
DIRECTIONS = {FORWARD: (1, 0), BACK: (-1, 0), LEFT: (0, 1), RIGHT: (0, -1)}


class HeldButtons:
    """Who holds which button; times in seconds."""

    def __init__(self):
        """Start with none held."""
        self._deadlines = {}

    def hold(self, client, button, now):
        """Note that a client holds a button."""
        self._deadlines[client, button] = now + HOLD_TIMEOUT

    def release(self, client, button=None):
        """Note that a client has released a button, or all of them."""
        self._deadlines = {held: deadline for held, deadline in self._deadlines.items()
                           if held[0] != client or button not in (None, held[1])}

    def clear(self):
        """Forget all of them."""
        self._deadlines = {}

    def command(self, now):
        """Return the shares of speed forwards and to the left, or None if nothing is held."""
        self._deadlines = {held: deadline for held, deadline in self._deadlines.items()
                           if deadline > now}
        buttons = {button for _, button in self._deadlines}
        if STOP in buttons:
            return STANDSTILL
        directions = [DIRECTIONS[button] for button in buttons]
        return tuple(map(sum, zip(*directions))) if directions else None


class Steering(HeldButtons):
    """Decides what the held buttons command to which robot; times in seconds.

    A robot that has not been driven is sent no commands.
    """

    def __init__(self):
        """Start without a robot."""
        super().__init__()
        self._chosen = None
        self._driven = None

    @property
    def is_driving(self):
        """Whether a robot has been told to move and has not been stopped."""
        return self._driven is not None

    def choose(self, robot):
        """Drive this robot from now on."""
        if robot != self._chosen:
            self.clear()
        self._chosen = robot

    def commands(self, now):
        """Return what to command: pairs of a robot and its shares of speed forwards and leftwards.

        While a robot is driven, ask again every COMMAND_PERIOD.
        """
        shares = self.command(now)
        wanted = None if shares is None else self._chosen
        stopped = [(self._driven, STANDSTILL)] if self._driven not in (None, wanted) else []
        self._driven = wanted
        return stopped if wanted is None else [*stopped, (wanted, shares)]
