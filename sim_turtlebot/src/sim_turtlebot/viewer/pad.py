"""The pad: drives the robot while a button or an arrow key is held, and not a moment longer."""

import html
import json
import threading
import time

from odometry_common.velocity import VelocityPublisher

HOLD_RATE = 10.0  # Hz, at which the page says that a button is still held
HOLD_TIMEOUT = 0.4  # s; who has not said so for this long holds it no more
COMMAND_PERIOD = 0.05  # s

FORWARD, BACK, LEFT, RIGHT, STOP = 'forward', 'back', 'left', 'right', 'stop'
# Shares of the greatest speed forwards and to the left.
DIRECTIONS = {FORWARD: (1, 0), BACK: (-1, 0), LEFT: (0, 1), RIGHT: (0, -1)}
ARROW_KEYS = {'ArrowUp': FORWARD, 'ArrowDown': BACK, 'ArrowLeft': LEFT, 'ArrowRight': RIGHT}


class Holds:
    """Who holds which button; times in seconds."""

    def __init__(self):
        """Nobody holds any."""
        self._deadlines = {}

    def hold(self, client, direction, now):
        """Take note that a client holds a direction."""
        self._deadlines[client, direction] = now + HOLD_TIMEOUT

    def release(self, client, direction=None):
        """Take note that a client has let go of a direction, or of all."""
        self._deadlines = {held: deadline for held, deadline in self._deadlines.items()
                           if held[0] != client or direction not in (None, held[1])}

    def clear(self):
        """Forget all."""
        self._deadlines = {}

    def command(self, now):
        """Return the shares of speed forwards and to the left, or None if nothing is held."""
        self._deadlines = {held: deadline for held, deadline in self._deadlines.items()
                           if deadline > now}
        held = [DIRECTIONS[direction] for direction in {key[1] for key in self._deadlines}]
        return tuple(map(sum, zip(*held))) if held else None


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while something is held."""

    def __init__(self, speeds):
        """Take a function that returns the speed (m/s) and the turning speed (rad/s)."""
        self._speeds = speeds
        self._holds = Holds()
        self._publishers = {}
        self._publisher = None
        self._lock = threading.Lock()
        self._changed = threading.Event()
        threading.Thread(target=self._drive, daemon=True).start()

    def choose(self, namespace):
        """Drive the robot in this namespace from now on."""
        if namespace not in self._publishers:
            self._publishers[namespace] = VelocityPublisher(f'{namespace}cmd_vel')
        with self._lock:
            if self._publisher is not self._publishers[namespace]:
                self._holds.clear()
            self._publisher = self._publishers[namespace]
        self._changed.set()

    def hold(self, client, direction):
        """Drive on for a short while."""
        with self._lock:
            self._holds.hold(client, direction, time.monotonic())
        self._changed.set()

    def release(self, client, direction=None):
        """Let go of a direction, or of all."""
        with self._lock:
            self._holds.release(client, direction)
        self._changed.set()

    def stop(self):
        """Let go of everything and command zero, whether or not the pad has driven."""
        with self._lock:
            self._holds.clear()
            publisher = self._publisher
        if publisher:
            publisher.stop()

    def _drive(self):
        driven = None
        while True:
            self._changed.wait(COMMAND_PERIOD if driven else None)
            self._changed.clear()
            with self._lock:
                publisher, command = self._publisher, self._holds.command(time.monotonic())
            if driven and (command is None or publisher is not driven):
                driven.stop()
                driven = None
            if command and publisher:
                forward, left = command
                speed, turn_speed = self._speeds()
                publisher.publish(forward * speed, left * turn_speed)
                driven = publisher


def add_pad(gui, pad):
    """Add the buttons of a Pad to the place in viser's GUI where things are being added."""
    gui.add_html(LAYOUT)
    for label in (FORWARD, LEFT, STOP, RIGHT, BACK):
        if label == STOP:
            gui.add_button(STOP, color='red').on_click(lambda _: pad.stop())
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
