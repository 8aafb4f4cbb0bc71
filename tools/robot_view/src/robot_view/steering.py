"""Compute commands from the held buttons of the pad."""

HOLD_RATE = 10.0  # Hz, at which a page repeats its holds
HOLD_TIMEOUT = 0.5  # s; without a repetition the button counts as released
COMMAND_PERIOD = 0.05  # s
STOP_TIMEOUT = 10.0  # s; a robot that takes longer to connect gets no zero

FORWARD, BACK, LEFT, RIGHT, STOP = 'forward', 'back', 'left', 'right', 'stop'
# Shares of the maximum speed, forwards and to the left.
STANDSTILL = 0, 0
DIRECTIONS = {
    FORWARD: (1, 0),
    BACK: (-1, 0),
    LEFT: (0, 1),
    RIGHT: (0, -1)}


class Steering:
    """Decides what the held buttons command to which robot; times in seconds.

    A robot gets commands while you hold a button for it, then zeros until it has received one. Stop
    disables every button that is held for the robot, or by this client, until it is released.
    """

    def __init__(self):
        self._held = {}  # robot and deadline by client and button, until the release
        self._stopped = set()  # clients and buttons
        self._driven = {}  # by robot that has not received its zero yet: until when it gets some

    @property
    def is_driving(self):
        """Whether a robot has not received its zero yet."""
        return bool(self._driven)

    def hold(self, client, button, robot, now):
        """Record that a client holds a button for a robot, or clicks stop.

        While it is held, a button stays with the robot for which it was pressed.
        """
        pressed_for, until = self._held.get((client, button), (robot, now))
        if button == STOP:
            # Also buttons past their deadline: a page that was silent may continue to hold them.
            # And those of this client for another robot, which it may have pressed before.
            self._stopped.update(
                held for held, (held_for, _) in self._held.items()
                if held[1] != STOP and (held_for == robot or held[0] == client))
        elif until > now:
            robot = pressed_for
        self._held[client, button] = robot, now + HOLD_TIMEOUT

    def release(self, client, button=None):
        """Record that a client has released a button, or all of them."""
        self._held = {held: until for held, until in self._held.items()
                      if held[0] != client or button not in (None, held[1])}
        self._stopped &= set(self._held)

    def commands(self, now):
        """Return a dictionary of shares of speed, forwards and to the left, by robot.

        While a robot drives, call this every COMMAND_PERIOD.
        """
        buttons = {}
        for held, (robot, until) in self._held.items():
            if until > now and held not in self._stopped:
                buttons.setdefault(robot, set()).add(held[1])
        self._driven.update(dict.fromkeys(buttons, now + STOP_TIMEOUT))
        self._driven = {robot: until for robot, until in self._driven.items() if until > now}
        # Stops first: no robot starts before the other one has its zero.
        stops = dict.fromkeys(self._driven.keys() - buttons.keys(), STANDSTILL)
        return {**stops, **{robot: _shares(held) for robot, held in buttons.items()}}

    def confirm_stop(self, robot):
        """Record that a robot has received a zero."""
        self._driven.pop(robot, None)


def _shares(buttons):
    if STOP in buttons:
        return STANDSTILL
    return tuple(map(sum, zip(*(DIRECTIONS[button] for button in buttons))))
