"""The pad: it drives a robot while a button or an arrow key is held, and no longer."""

import threading
import time

from odometry_common.connections import is_heard_within
from odometry_common.velocity import VelocityPublisher

from robot_view import steering
from robot_view.pad_layout import LAYOUT

LONGEST_CONNECTING = 10.0  # s; a robot that takes longer does not listen


class Pad:
    """Publishes velocities on the chosen robot's cmd_vel while a button is held.

    A robot that it has not driven receives nothing from it, not even when the node exits.
    """

    def __init__(self, chosen, speeds):
        """Take two functions.

        :param chosen: returns the namespace of the robot to drive; None if there is none
        :param speeds: returns the linear (m/s) and the angular speed (rad/s)
        """
        self._chosen = chosen
        self._speeds = speeds
        self._steering = steering.Steering()
        self._publishers = {}
        self._lock = threading.Lock()
        self._changed = threading.Event()
        threading.Thread(target=self._drive, daemon=True).start()

    def hold(self, client, button):
        """Command what the button says for HOLD_TIMEOUT."""
        robot = self._chosen()
        if robot is not None:
            with self._lock:
                self._steering.hold(client, button, robot, time.monotonic())
            self._changed.set()

    def release(self, client, button=None):
        """Release a button, or all of them."""
        with self._lock:
            self._steering.release(client, button)
        self._changed.set()

    def _drive(self):
        while True:
            self._changed.wait(steering.COMMAND_PERIOD if self._steering.is_driving else None)
            self._changed.clear()
            with self._lock:
                commands = self._steering.commands(time.monotonic())
            for namespace, shares in commands.items():
                self._command(namespace, *shares)

    def _command(self, namespace, forward, left):
        if namespace not in self._publishers:
            self._publishers[namespace] = publisher = VelocityPublisher(f'{namespace}cmd_vel')
            # Wait for the robot, or a first command to stop would be lost.
            is_heard_within(publisher, LONGEST_CONNECTING)
            if (forward, left) != steering.STANDSTILL:
                return  # the button may have been released meanwhile
        linear, angular = self._speeds()
        self._publishers[namespace].publish(forward * linear, left * angular)


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

    # Both run on the event loop, in the order of the messages: no hold comes after its release.
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
        # Held, it also reaches a robot that the pad has not driven before.
        pad.hold(event.client_id, steering.STOP)
