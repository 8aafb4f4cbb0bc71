"""The pad: drives the robot while a button or an arrow key is held, and not a moment longer."""

import html
import json
import threading
import time

from odometry_common.velocity import VelocityPublisher

HOLD_RATE = 10.0  # Hz, at which the page says that a button is still held
HOLD_TIMEOUT = 0.5  # s; who has not said so for this long holds it no more
COMMAND_PERIOD = 0.05  # s

FORWARD, BACK, LEFT, RIGHT, STOP = 'forward', 'back', 'left', 'right', 'stop'
# Shares of the greatest speed forwards and to the left.
STANDSTILL = 0, 0
DIRECTIONS = {FORWARD: (1, 0), BACK: (-1, 0), LEFT: (0, 1), RIGHT: (0, -1)}
ARROW_KEYS = {'ArrowUp': FORWARD, 'ArrowDown': BACK, 'ArrowLeft': LEFT, 'ArrowRight': RIGHT}


class Holds:
    """Who holds which button; times in seconds."""

    def __init__(self):
        """Nobody holds any."""
        self._deadlines = {}

    def hold(self, client, button, now):
        """Take note that a client holds a button."""
        self._deadlines[client, button] = now + HOLD_TIMEOUT

    def release(self, client, button=None):
        """Take note that a client has let go of a button, or of all."""
        self._deadlines = {held: deadline for held, deadline in self._deadlines.items()
                           if held[0] != client or button not in (None, held[1])}

    def clear(self):
        """Forget all."""
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


class Steering:
    """Decides what is commanded to which robot; times in seconds.

    A robot that nobody has driven is commanded nothing.
    """

    def __init__(self):
        """Drive none."""
        self._holds = Holds()
        self._chosen = None
        self._driven = None

    @property
    def is_driving(self):
        """Whether a robot has been told to move and has not been stopped."""
        return self._driven is not None

    def choose(self, robot):
        """Drive this robot from now on."""
        if robot != self._chosen:
            self._holds.clear()
        self._chosen = robot

    def hold(self, client, button, now):
        """Do what the button says for a short while."""
        self._holds.hold(client, button, now)

    def release(self, client, button=None):
        """Let go of a button, or of all."""
        self._holds.release(client, button)

    def commands(self, now):
        """Return what to command: pairs of a robot and its shares of speed forwards and to the left.

        While a robot is driven, ask again each COMMAND_PERIOD.
        """
        shares = self._holds.command(now)
        wanted = None if shares is None else self._chosen
        stopped = [(self._driven, STANDSTILL)] if self._driven not in (None, wanted) else []
        self._driven = wanted
        return stopped if wanted is None else [*stopped, (wanted, shares)]


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while something is held.

    A robot that it has not driven never hears of it, not even when the node ends.
    """

    def __init__(self, speeds):
        """Take a function that returns the speed (m/s) and the turning speed (rad/s)."""
        self._speeds = speeds
        self._steering = Steering()
        self._publishers = {}
        self._lock = threading.Lock()
        self._changed = threading.Event()
        threading.Thread(target=self._drive, daemon=True).start()

    def choose(self, namespace):
        """Drive the robot in this namespace from now on."""
        with self._lock:
            self._steering.choose(namespace)
        self._changed.set()

    def hold(self, client, button):
        """Do what the button says for a short while."""
        with self._lock:
            self._steering.hold(client, button, time.monotonic())
        self._changed.set()

    def release(self, client, button=None):
        """Let go of a button, or of all."""
        with self._lock:
            self._steering.release(client, button)
        self._changed.set()

    def _drive(self):
        while True:
            self._changed.wait(COMMAND_PERIOD if self._steering.is_driving else None)
            self._changed.clear()
            with self._lock:
                commands = self._steering.commands(time.monotonic())
            for namespace, (forward, left) in commands:
                speed, turn_speed = self._speeds()
                self._publisher(namespace).publish(forward * speed, left * turn_speed)

    def _publisher(self, namespace):
        if namespace not in self._publishers:
            self._publishers[namespace] = VelocityPublisher(f'{namespace}cmd_vel')
        return self._publishers[namespace]


def add_pad(gui, pad):
    """Add the buttons of a Pad to the place in viser's GUI where things are being added."""
    gui.add_html(LAYOUT)
    for label in (FORWARD, LEFT, STOP, RIGHT, BACK):
        if label == STOP:
            _add_stop(gui, pad)
        else:
            _add_direction(gui, pad, label)


def _add_direction(gui, pad, direction):
    button = gui.add_button(direction)

    # Both run on the event loop, one after the other: a release cannot overtake a hold.
    @button.on_hold(callback_hz=HOLD_RATE)
    async def _(event):
        pad.hold(event.client_id, direction)

    @button.on_click
    async def _(event):
        pad.release(event.client_id, direction)


def _add_stop(gui, pad):
    button = gui.add_button(STOP, color='red')

    @button.on_click
    async def _(event):
        # For as long as a hold lasts, so that it gets through to a robot not driven before.
        pad.hold(event.client_id, STOP)


# viser tells of keys that go down, not of keys that come up. So the page itself turns the arrow
# keys into presses of the buttons.
SCRIPT = '''
if (!window.arrowKeys) {
  window.arrowKeys = KEYS;
  const held = new Set();
  const button = (key) => [...document.querySelectorAll('button')].find(
    (candidate) => candidate.textContent.trim() === window.arrowKeys[key]);
  const pointer = (key, kind) => button(key)?.dispatchEvent(
    new PointerEvent(kind, {bubbles: true, button: 0}));
  const release = (key) => {
    if (!held.delete(key)) return;
    pointer(key, 'pointerup');
    button(key)?.click();
  };
  const releaseAll = () => [...held].forEach(release);
  window.addEventListener('keydown', (event) => {
    const typing = event.target.closest?.('input:not([type=range]), textarea, [role=slider]');
    if (!(event.key in window.arrowKeys) || typing) return;
    event.preventDefault();
    event.stopPropagation();
    if (held.has(event.key)) return;
    held.add(event.key);
    pointer(event.key, 'pointerdown');
  }, true);
  window.addEventListener('keyup', (event) => release(event.key), true);
  window.addEventListener('blur', releaseAll);
  document.addEventListener('visibilitychange', releaseAll);
}
'''.replace('KEYS', json.dumps(ARROW_KEYS))

STYLE = '''
div:has(> div > #pad) {display: grid; grid-template-columns: repeat(3, 1fr); padding: 0 0.4em}
div:has(> div > #pad) > :nth-child(1), div:has(> div > #pad) > :nth-child(n+7) {grid-column: 1/4}
div:has(> div > #pad) > :nth-child(2), div:has(> div > #pad) > :nth-child(6) {grid-column: 2}
div:has(> div > #pad) > :nth-child(3) {grid-column: 1}
div:has(> div > #pad) > :nth-child(n+2) > button {margin: 0; padding: 0; touch-action: none}
'''

LAYOUT = f'''<style>{STYLE}</style><img id="pad" alt="" src="data:," style="display:none"
onerror="{html.escape(SCRIPT)}">'''
