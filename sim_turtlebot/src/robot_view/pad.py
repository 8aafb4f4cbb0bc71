"""The pad: it drives the robot while a button or an arrow key is held, and no longer."""

import threading
import time

from odometry_common.connections import is_heard_within
from odometry_common.velocity import VelocityPublisher

from robot_view import steering
from robot_view.pad_html import LAYOUT

LONGEST_CONNECTING = 10.0  # s; no robot listens then


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while a button is held.

    A robot that it has not driven receives nothing from it, not even when the node ends.
    """

    def __init__(self, speeds):
        """Take a function that returns the linear (m/s) and the angular speed (rad/s)."""
        self._speeds = speeds
        self._steering = steering.Steering()
        self._publishers = {}
        self._lock = threading.Lock()
        self._changed = threading.Event()
        threading.Thread(target=self._drive, daemon=True).start()

    def choose(self, chosen):
        """Drive the robot in the namespace that `chosen()` returns from now on.

        It is asked while no other thread can choose, so that none brings an older choice.
        """
        self._tell(lambda: self._steering.choose(chosen()))

    def hold(self, client, button):
        """Do what the button says for a short while."""
        self._tell(self._steering.hold, client, button, time.monotonic())

    def release(self, client, button=None):
        """Release a button, or all of them."""
        self._tell(self._steering.release, client, button)

    def _tell(self, what, *arguments):
        with self._lock:
            what(*arguments)
        self._changed.set()

    def _drive(self):
        while True:
            self._changed.wait(steering.COMMAND_PERIOD if self._steering.is_driving else None)
            self._changed.clear()
            with self._lock:
                commands = self._steering.commands(time.monotonic())
            for namespace, shares in commands:
                self._command(namespace, *shares)

    def _command(self, namespace, forward, left):
        if namespace not in self._publishers:
            self._publishers[namespace] = _connected_publisher(f'{namespace}cmd_vel')
            if (forward, left) != steering.STANDSTILL:
                return  # the button may have been released meanwhile
        linear, angular = self._speeds()
        self._publishers[namespace].publish(forward * linear, left * angular)


def _connected_publisher(topic):
    """Return a VelocityPublisher once its robot hears it, lest a first command to stop get lost."""
    publisher = VelocityPublisher(topic)
    is_heard_within(publisher, LONGEST_CONNECTING)
    return publisher


def add_pad(gui, pad):
    """Add the buttons of a Pad at the current place in viser's GUI."""
    gui.add_html(LAYOUT)
    _add_direction(gui, pad, steering.FORWARD)
    _add_direction(gui, pad, steering.LEFT)
    _add_stop(gui, pad)
    _add_direction(gui, pad, steering.RIGHT)
    _add_direction(gui, pad, steering.BACK)


def _add_direction(gui, pad, direction):
    button = gui.add_button(direction)

    # Both run on the event loop, one after the other: a release cannot overtake a hold.
    @button.on_hold(callback_hz=steering.HOLD_RATE)
    async def _(event):
        pad.hold(event.client_id, direction)

    @button.on_click
    async def _(event):
        pad.release(event.client_id, direction)


def _add_stop(gui, pad):
    button = gui.add_button(steering.STOP, color='red')

    @button.on_click
    async def _(event):
        # As long as a hold lasts, so that it reaches even a robot that was not driven before.
        pad.hold(event.client_id, steering.STOP)
